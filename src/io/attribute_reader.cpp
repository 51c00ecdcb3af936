// Reads the attributes of files: one pass over each layer, without the geometry.
//
// The layer was read before. So the file must not have changed in the meantime: the ids of the features are compared.
// The order is nearly always the same; but SQLite may read a GeoPackage along an index of an attribute if the geometry
// is not asked for. Then rows are found by id.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "io/attribute_data.h"
#include "io/formats.h"
#include "io/gdal_source.h"

namespace oblast::io {

namespace {

// A column that holds the values of both. 32-bit integers are exact as 64-bit integers and as numbers.
Column wider(const Column& a, const Column& b) {
  Column column = a;
  if (a.subtype != b.subtype) column.subtype = ColumnSubtype::none;
  column.width = a.width == 0 || b.width == 0 ? 0 : std::max(a.width, b.width);
  column.precision = std::max(a.precision, b.precision);
  if (a.type == b.type) return column;
  const auto are = [&](ColumnType s, ColumnType t) {
    return (a.type == s && b.type == t) || (a.type == t && b.type == s);
  };
  column.subtype = ColumnSubtype::none;
  column.width = column.precision = 0;
  if (are(ColumnType::integer, ColumnType::integer64)) {
    column.type = ColumnType::integer64;
  } else if (are(ColumnType::integer, ColumnType::real)) {
    column.type = ColumnType::real;
  } else {
    column.type = ColumnType::text;
  }
  return column;
}

class TableReader {
 public:
  TableReader(const Layer& layer, std::vector<std::string>& notes) : layer_(layer), notes_(notes) {
    data_->rows.resize(layer.features.size());
  }

  void skip_wkt() { begin_part(); }

  void read(const GdalSource::Entry& entry, GdalMessages& messages) {
    begin_part();
    add_columns(*entry.layer->GetLayerDefn(), entry.name);
    messages.clear();
    const char* const no_geometry[] = {"OGR_GEOMETRY", "OGR_STYLE", nullptr};
    if (entry.layer->TestCapability(OLCIgnoreFields))
      entry.layer->SetIgnoredFields(const_cast<const char**>(no_geometry));
    const std::size_t first = first_row(file_), end = first_row(file_ + 1);
    std::size_t count = 0;
    while (std::unique_ptr<OGRFeature> feature{entry.layer->GetNextFeature()}) {
      if (first + count == end) changed(entry.name);
      const std::size_t row = row_of(feature->GetFID(), first + count++, end);
      if (row == end || data_->rows[row]) changed(entry.name);
      feature->SetGeometryDirectly(nullptr);
      data_->rows[row] = std::move(feature);
    }
    if (messages.failed()) throw IoError(entry.name + ": cannot be read to the end: " + messages.text(""));
    if (first + count != end) changed(entry.name);
  }

  std::unique_ptr<AttributeTable::Data> finish() {
    for (auto& part : data_->parts) part.field_of_column.resize(data_->columns.size(), -1);
    return std::move(data_);
  }

 private:
  [[noreturn]] static void changed(const std::string& name) {
    throw IoError(name + " changed while it was read; run the command again");
  }

  void begin_part() {
    if (!data_->parts.empty()) ++file_;
    row_of_id_.clear();
    data_->parts.push_back({first_row(file_), {}});
  }
  std::size_t first_row(std::uint32_t file) const {
    const auto at = std::partition_point(layer_.features.begin(), layer_.features.end(),
                                         [file](const FeatureRange& f) { return f.file < file; });
    return static_cast<std::size_t>(at - layer_.features.begin());
  }
  // Usually `expected`; `end` if there is no such id among the rows of the file.
  std::size_t row_of(std::int64_t id, std::size_t expected, std::size_t end) {
    if (row_of_id_.empty() && layer_.features[expected].feature == id) return expected;
    if (row_of_id_.empty()) {
      for (std::size_t row = first_row(file_); row < end; ++row) row_of_id_.emplace(layer_.features[row].feature, row);
    }
    const auto found = row_of_id_.find(id);
    return found == row_of_id_.end() ? end : found->second;
  }

  void add_columns(const OGRFeatureDefn& definition, const std::string& file) {
    auto& field_of_column = data_->parts.back().field_of_column;
    std::set<std::string> of_file;
    for (int f = 0; f < definition.GetFieldCount(); ++f) {
      Column column = column_of(*definition.GetFieldDefn(f));
      // A file may have two columns of one name.
      const std::string name = column.name;
      for (int number = 1; !of_file.insert(column.name).second; ++number)
        column.name = fmt::format("{}_{}", name, number);
      const auto [at, is_new] = column_by_name_.try_emplace(column.name, data_->columns.size());
      if (is_new) {
        data_->columns.push_back(column);
        file_of_column_.push_back(file);
      } else {
        widen(data_->columns[at->second], column, file_of_column_[at->second], file);
      }
      field_of_column.resize(data_->columns.size(), -1);
      field_of_column[at->second] = f;
    }
  }

  // Wider numbers have the same values; text is another thing, and is said once for each type.
  void widen(Column& column, const Column& other, const std::string& file, const std::string& other_file) {
    const Column result = wider(column, other);
    if (column.type != other.type && result.type == ColumnType::text &&
        said_.insert({column.name, other.type}).second) {
      notes_.push_back(fmt::format("{} has {} in {} and {} in {}; it is read as {}", column.name, name(column.type),
                                   file, name(other.type), other_file, name(result.type)));
    }
    column = result;
  }

  const Layer& layer_;
  std::vector<std::string>& notes_;
  std::unique_ptr<AttributeTable::Data> data_ = std::make_unique<AttributeTable::Data>();
  std::map<std::string, std::size_t> column_by_name_;
  std::vector<std::string> file_of_column_;
  std::set<std::pair<std::string, ColumnType>> said_;
  std::uint32_t file_ = 0;
  std::unordered_map<std::int64_t, std::size_t> row_of_id_;  // of the present file, if its order has changed
};

}  // namespace

AttributeTable read_attributes(std::span<const std::string> files, const std::string& where, const Layer& layer,
                               std::vector<std::string>& notes) {
  TableReader reader(layer, notes);
  for (const std::string& path : files) {
    if (is_wkt(path)) {
      reader.skip_wkt();
      continue;
    }
    GdalSource source(path);
    for (const GdalSource::Entry& entry : source.layers()) {
      set_condition(entry, where, source.messages());
      reader.read(entry, source.messages());
    }
  }
  return AttributeTable(reader.finish());
}

}  // namespace oblast::io
