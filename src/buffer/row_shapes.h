// The shapes of each row of a layer.
#pragma once

#include <oblast/buffer.h>

#include <cstdint>

#include "base/call_memory.h"

namespace oblast::internal::buffering {

class RowShapes {
 public:
  /// Throws Error(bad_option) if the row numbers do not fit the shapes, or one is not below `rows`.
  RowShapes(const ShapeFeatures& features, std::size_t rows);

  /// The shapes of one row, copied.
  struct Row {
    Array<Point> region_points, line_points, points;
    Array<std::uint32_t> contour_ends, polygon_ends, line_ends;

    ShapeView view() const { return {{region_points, contour_ends, polygon_ends}, {line_points, line_ends}, points}; }
  };
  Row row(std::size_t f) const;

 private:
  /// Which polygons (or lines, or points) belong to which row: those of row f are items[ends[f-1] .. ends[f]).
  struct Index {
    Array<std::uint32_t> ends, items;

    std::span<const std::uint32_t> of(std::size_t f) const {
      const std::uint32_t begin = f == 0 ? 0 : ends[f - 1];
      return std::span(items).subspan(begin, ends[f] - begin);
    }
  };
  static Index index_of(std::span<const std::uint32_t> rows, std::size_t count, std::size_t first_row,
                        std::size_t row_count, const char* what);

  const ShapeView& shapes_;
  Index polygons_, lines_, points_;
};

}  // namespace oblast::internal::buffering
