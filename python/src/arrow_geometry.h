// A column of polygons in Arrow memory: which encoding it has, and the rows of one chunk of it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "arrays.h"
#include "arrow_abi.h"
#include "call.h"

namespace oblast::python {

enum class Encoding { polygon, multipolygon, wkb };

/// The column of a schema, and how to get to it from the array.
struct GeometryColumn {
  int child = -1;  ///< of a table: which of its columns; -1: the array itself is the column
  Encoding encoding = Encoding::polygon;
  bool large = false;       ///< WKB with 64-bit offsets
  bool interleaved = true;  ///< x y x y ..., else a struct of x and y
  int dimensions = 2;
  std::vector<bool> large_lists;  ///< by level of lists, the outermost first: whether offsets have 64 bits
  std::string metadata;           ///< of the extension, as it is: the CRS
};

/// Finds the column `name`, or the only geometry column if `name` is empty. Throws nb::type_error.
GeometryColumn geometry_column(const ArrowSchema& schema, const std::string& name);

using ArrowOwner = std::shared_ptr<const ArrowArray>;

/// The rows of one chunk. Interleaved coordinates are viewed, and `chunk` is kept alive; separate ones are copied. A
/// null is a row without polygons. `has_z` becomes true if Z or M was left out.
Arrays rows_of_chunk(const ArrowOwner& chunk, const GeometryColumn& column, const Settings& settings, bool& has_z);

}  // namespace oblast::python
