// The columns of rows that are written: where the value of each row comes from. Values are joined by index when they
// are written, so no table is copied.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "io/attribute_table.h"

namespace oblast::io {

/// A computed value; the first alternative is null.
using Value = std::variant<std::monostate, std::int64_t, double, std::string, std::vector<std::int64_t>,
                           std::vector<double>, std::vector<std::string>>;

/// Either a column of a table, or computed values.
struct OutputColumn {
  Column column;
  const AttributeTable* table = nullptr;  ///< null: `values`
  std::size_t index = 0;                  ///< column of `table`
  /// By row written: the row of `table`, or no_feature, which is null.
  std::span<const std::uint32_t> rows = {};
  std::vector<Value> values = {};  ///< by row written
};

}  // namespace oblast::io
