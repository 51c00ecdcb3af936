// The attributes of several files as one table: columns are joined by name.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "io/attribute_data.h"
#include "io/read_parts.h"

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

class TableJoin {
 public:
  explicit TableJoin(std::vector<std::string>& notes) : notes_(notes) {}

  void add(FilePart& part) {
    data_->parts.push_back({data_->rows.size(), {}});
    add_columns(part.table.columns, part.layer.files.front());
    // WKT has rows without features.
    const std::size_t end = data_->rows.size() + part.layer.features.size();
    std::move(part.table.rows.begin(), part.table.rows.end(), std::back_inserter(data_->rows));
    data_->rows.resize(end);
    part.table.rows.clear();
  }

  std::unique_ptr<AttributeTable::Data> finish() {
    for (auto& part : data_->parts) part.field_of_column.resize(data_->columns.size(), -1);
    return std::move(data_);
  }

 private:
  void add_columns(const std::vector<Column>& fields, const std::string& file) {
    auto& field_of_column = data_->parts.back().field_of_column;
    std::set<std::string> of_file;
    for (std::size_t f = 0; f < fields.size(); ++f) {
      Column column = fields[f];
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
      field_of_column[at->second] = static_cast<int>(f);
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

  std::vector<std::string>& notes_;
  std::unique_ptr<AttributeTable::Data> data_ = std::make_unique<AttributeTable::Data>();
  std::map<std::string, std::size_t> column_by_name_;
  std::vector<std::string> file_of_column_;
  std::set<std::pair<std::string, ColumnType>> said_;
};

}  // namespace

AttributeTable join_tables(Parts& parts, std::vector<std::string>& notes) {
  TableJoin join(notes);
  for (FilePart& part : parts.files) join.add(part);
  return AttributeTable(join.finish());
}

}  // namespace oblast::io
