// Rows of regions as a column in Arrow memory: GeoArrow polygon or multipolygon.
#pragma once

#include <memory>

#include "arrays.h"
#include "arrow_abi.h"

namespace oblast::python {

/// The arrays of a column. GeoArrow has closed rings, so points are copied.
struct ArrowColumn {
  bool multipolygon = true;
  bool interleaved = true;
  std::vector<std::int32_t> rows, polygons, rings;  ///< offsets; `polygons` are of polygons in rings
  std::vector<double> x, y;                         ///< x has both if interleaved
};

/// Throws nb::value_error if a row has several polygons and `multipolygon` is false.
std::shared_ptr<const ArrowColumn> make_column(const Arrays& rows, bool multipolygon, bool interleaved);

void export_schema(const ArrowColumn& column, ArrowSchema& out);
/// The array keeps the column alive until it is released.
void export_array(const std::shared_ptr<const ArrowColumn>& column, ArrowArray& out);
/// A stream of one chunk.
void export_stream(const std::shared_ptr<const ArrowColumn>& column, ArrowArrayStream& out);

}  // namespace oblast::python
