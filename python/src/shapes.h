// Regions, lines and points of the same rows, as three arrays: a line is a ring of `lines`, and a point is a ring of
// `points`, so that errors find their rows.
#pragma once

#include <oblast/buffer.h>

#include <cstdint>
#include <vector>

#include "arrays.h"

namespace oblast::python {

/// Of each ring, in order: its row.
inline std::vector<std::uint32_t> rows_of_rings(const Arrays& arrays) {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t row = 0; row < arrays.row_count(); ++row)
    rows.resize(arrays.polygon_offsets[arrays.row_offsets[row + 1]], row);
  return rows;
}

inline std::vector<std::uint32_t> rows_of_polygons(const Arrays& arrays) {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t row = 0; row < arrays.row_count(); ++row) rows.resize(arrays.row_offsets[row + 1], row);
  return rows;
}

inline ShapeView shapes_of(const Arrays& regions, const Arrays& lines, const Arrays& points) {
  return {regions.regions(), {lines.points, lines.ring_offsets.subspan(1)}, points.points};
}

}  // namespace oblast::python
