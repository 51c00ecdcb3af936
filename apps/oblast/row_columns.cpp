// The columns of results: chosen by name, joined by index.
#include <fmt/format.h>

#include <algorithm>

#include "oblast/row_job.h"

namespace oblast::app {

void ResultColumns::join(const io::AttributeTable& table, std::size_t index, std::span<const std::uint32_t> rows) {
  columns.push_back({table.columns()[index], &table, index, rows});
}

void ResultColumns::add(const std::string& name, io::ColumnType type, std::vector<io::Value> values) {
  columns.push_back({.column = {name, type}, .values = std::move(values)});
}

void ResultColumns::add(const std::string& name, const std::vector<double>& values) {
  add(name, io::ColumnType::real, std::vector<io::Value>(values.begin(), values.end()));
}

std::vector<std::size_t> selected(const io::AttributeTable& table, const std::vector<std::string>& select) {
  std::vector<std::size_t> columns;
  for (std::size_t c = 0; c < table.columns().size(); ++c) {
    if (select.empty() || std::find(select.begin(), select.end(), table.columns()[c].name) != select.end())
      columns.push_back(c);
  }
  return columns;
}

void check_column(const std::string& name, std::span<const io::Rows> layers) {
  std::string known, files;
  for (const io::Rows& layer : layers) {
    if (layer.table.find(name)) return;
    files += (files.empty() ? "" : " and ") + layer.layer.files.front();
    for (const io::Column& column : layer.table.columns()) known += (known.empty() ? "" : ", ") + column.name;
  }
  throw io::IoError(fmt::format("{}: there is no column {}; {}", files, name,
                                known.empty() ? "there are no columns at all" : "choose from " + known));
}

}  // namespace oblast::app
