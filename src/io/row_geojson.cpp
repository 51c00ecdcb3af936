// Rows as GeoJSON. A number of a column of numbers always has a point or an exponent, so that readers see its type.
#include <cpl_json.h>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "io/attribute_data.h"
#include "io/crs.h"
#include "io/gdal_session.h"
#include "io/geojson_writer.h"
#include "io/row_fields.h"
#include "io/row_writers.h"

namespace oblast::io {

namespace {

struct Release {
  void operator()(OGRFeatureDefn* definition) const { definition->Release(); }
};

constexpr std::size_t most_parts = 256;  // of the text, which are made on all cores

std::string real_text(const OGRFeature& feature, int field) {
  const double value = feature.GetFieldAsDouble(field);
  if (!std::isfinite(value)) return "null";
  std::string text = field_text(feature, field);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

bool is_json(const std::string& text) {
  GdalMessages messages;
  CPLJSONDocument document;
  return document.LoadMemory(text);
}

std::string value_text(const OGRFeature& feature, int field) {
  if (!feature.IsFieldSetAndNotNull(field)) return "null";
  const OGRFieldDefn& definition = *feature.GetFieldDefnRef(field);
  switch (definition.GetType()) {
    case OFTInteger:
      if (definition.GetSubType() == OFSTBoolean) return feature.GetFieldAsInteger(field) ? "true" : "false";
      return field_text(feature, field);
    case OFTInteger64:
      return field_text(feature, field);
    case OFTReal:
      return real_text(feature, field);
    case OFTIntegerList:
    case OFTInteger64List:
    case OFTRealList:
    case OFTStringList:
      return list_text(feature, field);
    default: {
      std::string text = field_text(feature, field);
      return definition.GetSubType() == OFSTJSON && is_json(text) ? text : json_string(text);
    }
  }
}

using Counts = std::vector<std::uint64_t>;  // by column

class RowsText {
 public:
  explicit RowsText(const RowOutput& output) : output_(output), plan_(plan_fields(output.columns, ".geojson")) {
    definition_.reset(OGRFeatureDefn::CreateFeatureDefn("rows"));
    definition_->Reference();
    definition_->SetGeomType(wkbNone);
    for (const Column& field : plan_.fields) {
      OGRFieldDefn defined(field.name.c_str(), OFTString);
      define(defined, field);
      definition_->AddFieldDefn(&defined);
      names_.push_back(json_string(field.name));
    }
  }

  std::size_t columns() const { return names_.size(); }

  /// Counts in `not_finite` numbers that GeoJSON cannot hold. Several threads may call it.
  void append_row(std::string& text, std::size_t row, Counts& not_finite) const {
    text += R"({"type":"Feature","properties":{)";
    OGRFeature feature(definition_.get());
    RowFields(output_.columns, plan_).fill(feature, row);
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const int field = static_cast<int>(i);
      text += (i ? "," : "") + names_[i] + ":" + value_text(feature, field);
      if (plan_.fields[i].type == ColumnType::real && feature.IsFieldSetAndNotNull(field) &&
          !std::isfinite(feature.GetFieldAsDouble(field)))
        ++not_finite[i];
    }
    text += R"(},"geometry":)";
    append_geometry(text, row);
    text += '}';
  }

  void add_notes(const Counts& not_finite, std::vector<std::string>& notes) const {
    notes.insert(notes.end(), plan_.notes.begin(), plan_.notes.end());
    for (std::size_t i = 0; i < not_finite.size(); ++i) {
      if (not_finite[i])
        notes.push_back(fmt::format("{}: {} of the values are not finite; GeoJSON has null for them",
                                    plan_.fields[i].name, not_finite[i]));
    }
  }

 private:
  void append_geometry(std::string& text, std::size_t row) const {
    const FeatureView& rows = output_.rows;
    const std::size_t begin = rows.feature_begin(row), end = rows.feature_end(row);
    if (begin == end) {
      text += "null";
      return;
    }
    const bool several = end - begin > 1;
    text += several ? R"({"type":"MultiPolygon","coordinates":[)" : R"({"type":"Polygon","coordinates":)";
    for (std::size_t p = begin; p < end; ++p) {
      if (p > begin) text += ',';
      append_geojson_polygon(text, rows.regions, p);
    }
    text += several ? "]}" : "}";
  }

  const RowOutput& output_;
  FieldPlan plan_;
  std::unique_ptr<OGRFeatureDefn, Release> definition_;
  std::vector<std::string> names_;
};

}  // namespace

std::string rows_to_geojson(const RowOutput& output, std::vector<std::string>& notes) {
  const RowsText rows(output);
  const std::size_t count = output.rows.feature_count();
  struct Part {
    std::string text;
    Counts not_finite;
  };
  const std::size_t size = std::max<std::size_t>(1, count / most_parts);  // rows
  std::vector<Part> parts((count + size - 1) / size);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t p) {
    auto& [text, not_finite] = parts[p];
    not_finite.resize(rows.columns(), 0);
    for (std::size_t row = p * size; row < std::min(count, (p + 1) * size); ++row) {
      rows.append_row(text, row, not_finite);
      text += row + 1 < count ? ",\n" : "\n";
    }
  });
  std::string text = geojson_begin(geojson_crs_code(output.crs_wkt));
  std::size_t bytes = text.size() + 3;
  for (const Part& part : parts) bytes += part.text.size();
  text.reserve(bytes);
  Counts not_finite(rows.columns(), 0);
  for (Part& part : parts) {
    text += std::exchange(part.text, {});
    for (std::size_t i = 0; i < not_finite.size(); ++i) not_finite[i] += part.not_finite[i];
  }
  rows.add_notes(not_finite, notes);
  return text + "]}\n";
}

}  // namespace oblast::io
