// Rows as CSV (RFC 4180) with the polygons as WKT in the first column, as GDAL and QGIS read it. A null is an empty
// field, and so is an empty text.
#include <fmt/format.h>

#include <memory>

#include "io/attribute_data.h"
#include "io/row_fields.h"
#include "io/row_writers.h"
#include "io/write.h"

namespace oblast::io {

namespace {

struct Release {
  void operator()(OGRFeatureDefn* definition) const { definition->Release(); }
};

void append_quoted(std::string& table, const std::string& text) {
  if (text.find_first_of(",;\t\"\r\n ") == std::string::npos) {
    table += text;
    return;
  }
  table += '"';
  for (const char c : text) table += c == '"' ? std::string("\"\"") : std::string(1, c);
  table += '"';
}

// The words of GDAL's .csvt files.
std::string type_word(const Column& column) {
  if (column.subtype == ColumnSubtype::boolean) return "Integer(Boolean)";
  if (column.subtype == ColumnSubtype::int16) return "Integer(Int16)";
  if (column.subtype == ColumnSubtype::float32) return "Real(Float32)";
  switch (column.type) {
    case ColumnType::integer:
      return "Integer";
    case ColumnType::integer64:
      return "Integer64";
    case ColumnType::real:
      return "Real";
    case ColumnType::date:
      return "Date";
    case ColumnType::time:
      return "Time";
    case ColumnType::date_time:
      return "DateTime";
    default:
      return "String";
  }
}

}  // namespace

CsvText rows_to_csv(const RowOutput& output, std::vector<std::string>& notes) {
  const FieldPlan plan = plan_fields(output.columns, ".csv");
  notes.insert(notes.end(), plan.notes.begin(), plan.notes.end());
  const RowFields fields(output.columns, plan);
  const std::unique_ptr<OGRFeatureDefn, Release> definition(OGRFeatureDefn::CreateFeatureDefn("rows"));
  definition->Reference();
  definition->SetGeomType(wkbNone);
  CsvText csv{"WKT", "\"WKT\""};
  for (const Column& field : plan.fields) {
    if (field.name == "WKT")
      throw IoError(
          fmt::format("cannot write {}: a column is called WKT, which is the column of the polygons in CSV; "
                      "leave it out with --select, or write .gpkg",
                      output.name));
    OGRFieldDefn defined(field.name.c_str(), OFTString);
    define(defined, field);
    definition->AddFieldDefn(&defined);
    csv.table += ',';
    append_quoted(csv.table, field.name);
    csv.types += ",\"" + type_word(field) + '"';
  }
  csv.table += '\n';
  csv.types += '\n';
  std::uint64_t empty = 0;
  for (std::size_t row = 0; row < output.rows.feature_count(); ++row) {
    if (output.rows.feature_begin(row) < output.rows.feature_end(row))
      append_quoted(csv.table, to_wkt(regions_of(output.rows, row)));
    OGRFeature feature(definition.get());
    fields.fill(feature, row);
    for (int i = 0; i < feature.GetFieldCount(); ++i) {
      csv.table += ',';
      if (!feature.IsFieldSetAndNotNull(i)) continue;
      const std::string text = field_text(feature, i);
      empty += text.empty();
      append_quoted(csv.table, text);
    }
    csv.table += '\n';
  }
  if (empty > 0) notes.push_back(fmt::format("empty texts: {}, which CSV does not tell from nulls; .gpkg does", empty));
  return csv;
}

}  // namespace oblast::io
