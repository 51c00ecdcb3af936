// Sorts the rows by value; see groups.h.
#include "oblast/groups.h"

#include <algorithm>
#include <numeric>

namespace oblast::app {

Groups group_rows(const io::AttributeTable& table, const std::vector<std::size_t>& columns) {
  const auto order = [&](std::uint32_t a, std::uint32_t b) {
    for (const std::size_t column : columns) {
      const std::weak_ordering found = table.compare(column, a, b);
      if (found != 0) return found;
    }
    return std::weak_ordering::equivalent;
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
