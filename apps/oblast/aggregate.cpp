// Functions of the values of groups; see aggregate.h.
#include "oblast/aggregate.h"

#include <fmt/format.h>
#include <oblast/features.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>

namespace oblast::app {

namespace {

constexpr const char* functions[] = {"first", "last", "sum", "mean", "min", "max", "count", "list"};

struct Source {
  const io::AttributeTable& table;
  std::size_t column;

  const io::Column& definition() const { return table.columns()[column]; }
  bool is_null(std::uint32_t row) const { return table.is_null(row, column); }
};

// The row of the group whose value it has.
std::uint32_t row_of(const Source& source, Aggregation function, const std::vector<std::uint32_t>& group) {
  std::uint32_t found = no_feature;
  for (const std::uint32_t row : group) {
    if (source.is_null(row)) continue;
    if (found == no_feature || function == Aggregation::last) {
      found = row;
    } else if (function != Aggregation::first) {
      const auto order = source.table.compare(source.column, row, found);
      if (function == Aggregation::min ? order < 0 : order > 0) found = row;
    }
  }
  return found;
}

io::Value sum_of_integers(const Source& source, const std::vector<std::uint32_t>& rows) {
  std::int64_t sum = 0;
  for (const std::uint32_t row : rows) {
    if (__builtin_add_overflow(sum, source.table.integer(row, source.column), &sum))
      throw io::IoError(fmt::format("the sum of {} is larger than a 64-bit integer", source.definition().name));
  }
  return sum;
}

double sum_of_numbers(const Source& source, const std::vector<std::uint32_t>& rows) {
  double sum = 0;
  for (const std::uint32_t row : rows) sum += source.table.real(row, source.column);
  return sum;
}

io::Value list_of(const Source& source, const std::vector<std::uint32_t>& rows) {
  const auto collect = [&](auto read) {
    std::vector<decltype(read(0U))> items;
    items.reserve(rows.size());
    for (const std::uint32_t row : rows) items.push_back(read(row));
    return io::Value(std::move(items));
  };
  const io::ColumnType type = source.definition().type;
  if (io::is_integer(type)) return collect([&](std::uint32_t row) { return source.table.integer(row, source.column); });
  if (type == io::ColumnType::real)
    return collect([&](std::uint32_t row) { return source.table.real(row, source.column); });
  return collect([&](std::uint32_t row) { return source.table.text(row, source.column); });
}

io::ColumnType type_of(const Source& source, Aggregation function) {
  const io::ColumnType type = source.definition().type;
  const bool whole = io::is_integer(type);
  switch (function) {
    case Aggregation::sum:
      return whole ? io::ColumnType::integer64 : io::ColumnType::real;
    case Aggregation::mean:
      return io::ColumnType::real;
    case Aggregation::count:
      return io::ColumnType::integer;
    default:
      if (whole) return io::ColumnType::integer64_list;
      return type == io::ColumnType::real ? io::ColumnType::real_list : io::ColumnType::text_list;
  }
}

// `rows` are those whose value is not null.
io::Value value_of(const Source& source, Aggregation function, const std::vector<std::uint32_t>& rows) {
  if (function == Aggregation::count) return static_cast<std::int64_t>(rows.size());
  if (rows.empty()) return {};
  if (function == Aggregation::list) return list_of(source, rows);
  if (function == Aggregation::mean) return sum_of_numbers(source, rows) / static_cast<double>(rows.size());
  if (io::is_integer(source.definition().type)) return sum_of_integers(source, rows);
  return sum_of_numbers(source, rows);
}

}  // namespace

std::string name(Aggregation function) { return functions[static_cast<int>(function)]; }

Aggregate parse_aggregate(const std::string& word) {
  const std::size_t colon = word.rfind(':');
  const std::string function = colon == std::string::npos ? "" : word.substr(colon + 1);
  const auto found = std::find(std::begin(functions), std::end(functions), function);
  if (found == std::end(functions) || colon == 0) {
    throw CLI::ValidationError(
        fmt::format("'{}' is not a column and a function, such as people:sum; functions are first, last, sum, mean, "
                    "min, max, count and list",
                    word));
  }
  return {word.substr(0, colon), static_cast<Aggregation>(found - std::begin(functions))};
}

void add_aggregate(const io::AttributeTable& table, std::size_t column, Aggregation function, const std::string& name,
                   const Groups& groups, ResultColumns& columns) {
  const Source source{table, column};
  using enum Aggregation;
  if (function == first || function == last || function == min || function == max) {
    auto& rows = columns.indices.emplace_back();
    for (const auto& group : groups.rows) rows.push_back(row_of(source, function, group));
    columns.join(table, column, rows);
    columns.columns.back().column.name = name;
    return;
  }
  if ((function == sum || function == mean) && !io::is_number(source.definition().type)) {
    throw io::IoError(fmt::format("column {} has {}, which have no {}; choose first, last, min, max, count or list",
                                  source.definition().name, io::name(source.definition().type), app::name(function)));
  }
  std::vector<io::Value> values;
  for (const auto& group : groups.rows) {
    std::vector<std::uint32_t> rows;
    std::copy_if(group.begin(), group.end(), std::back_inserter(rows),
                 [&](std::uint32_t row) { return !source.is_null(row); });
    values.push_back(value_of(source, function, rows));
  }
  columns.add(name, type_of(source, function), std::move(values));
}

}  // namespace oblast::app
