// Groups of the rows of a table by the values of some columns.
#pragma once

#include <cstdint>
#include <vector>

#include "io/attribute_table.h"

namespace oblast::app {

struct Groups {
  std::vector<std::uint32_t> group_of_row;
  std::vector<std::vector<std::uint32_t>> rows;  ///< by group, ascending

  std::size_t size() const { return rows.size(); }
};

/// Groups are in the order of their values, ascending: numbers as numbers, text by bytes, nulls last, as a group of
/// their own. Without columns, all rows are one group. Cost: O(n log n).
Groups group_rows(const io::AttributeTable& table, const std::vector<std::size_t>& columns);

}  // namespace oblast::app
