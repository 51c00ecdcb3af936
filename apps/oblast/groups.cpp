// Ranks of values, and rows sorted by them; see groups.h.
#include "oblast/groups.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <unordered_map>

namespace oblast::app {

namespace {

using Ranks = std::vector<std::uint32_t>;  // by row: equal values have the same, smaller ones a smaller

// `rows` in the order of their values. Gives each of them its rank.
void rank(const io::AttributeTable& table, std::size_t column, std::vector<std::uint32_t> rows, Ranks& ranks) {
  std::stable_sort(rows.begin(), rows.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return table.compare(column, a, b) < 0; });
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0 && table.compare(column, rows[i - 1], rows[i]) != 0) ++next;
    ranks[rows[i]] = next;
  }
}

// Of text and whole numbers few values are different, as a rule: only the first row of each value is sorted.
Ranks ranks_of(const io::AttributeTable& table, std::size_t column) {
  const auto rows = static_cast<std::uint32_t>(table.row_count());
  Ranks ranks(rows);
  const io::ColumnType type = table.columns()[column].type;
  std::vector<std::uint32_t> first(rows);  // row with the same value
  std::iota(first.begin(), first.end(), 0);
  if (type == io::ColumnType::text || io::is_integer(type)) {
    std::unordered_map<std::string, std::uint32_t> row_of_value;
    std::uint32_t null = rows;
    for (std::uint32_t row = 0; row < rows; ++row) {
      if (table.is_null(row, column)) {
        null = std::min(null, row);
        first[row] = null;
      } else {
        first[row] = row_of_value.try_emplace(table.text(row, column), row).first->second;
      }
    }
  }
  std::vector<std::uint32_t> different;
  for (std::uint32_t row = 0; row < rows; ++row)
    if (first[row] == row) different.push_back(row);
  rank(table, column, std::move(different), ranks);
  for (std::uint32_t row = 0; row < rows; ++row) ranks[row] = ranks[first[row]];
  return ranks;
}

}  // namespace

Groups group_rows(const io::AttributeTable& table, const std::vector<std::size_t>& columns) {
  std::vector<Ranks> ranks;
  ranks.reserve(columns.size());
  for (const std::size_t column : columns) ranks.push_back(ranks_of(table, column));
  const auto order = [&](std::uint32_t a, std::uint32_t b) {
    for (const Ranks& of_column : ranks)
      if (of_column[a] != of_column[b]) return of_column[a] <=> of_column[b];
    return std::strong_ordering::equal;
  };
  std::vector<std::uint32_t> rows(table.row_count());
  std::iota(rows.begin(), rows.end(), 0);
  std::stable_sort(rows.begin(), rows.end(), [&](std::uint32_t a, std::uint32_t b) { return order(a, b) < 0; });
  Groups groups;
  groups.group_of_row.resize(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i == 0 || order(rows[i - 1], rows[i]) != 0) groups.rows.emplace_back();
    groups.rows.back().push_back(rows[i]);
    groups.group_of_row[rows[i]] = static_cast<std::uint32_t>(groups.size() - 1);
  }
  return groups;
}

}  // namespace oblast::app
