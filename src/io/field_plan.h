// What becomes of columns in a format that cannot hold them as they are.
#pragma once

#include <string>
#include <vector>

#include "io/row_columns.h"

namespace oblast::io {

struct FieldPlan {
  std::vector<Column> fields;      ///< by column: what is written
  std::vector<std::string> notes;  ///< a line for every change
  std::size_t longest_text = 0;    ///< bytes; 0: any length
};

/// `path` has the extension of the format. Throws IoError if a column cannot be converted.
FieldPlan plan_fields(std::span<const OutputColumn> columns, const std::string& path);

}  // namespace oblast::io
