#include "buffer/row_shapes.h"

#include <string>

#include "base/index.h"

namespace oblast::internal::buffering {

RowShapes::Index RowShapes::index_of(std::span<const std::uint32_t> rows, std::size_t count, std::size_t first_row,
                                     std::size_t row_count, const char* what) {
  if (!rows.empty() && rows.size() != count)
    throw Error(ErrorCode::bad_option, "there are " + std::to_string(rows.size()) + " row numbers for " +
                                           std::to_string(count) + ' ' + what + "; it must be one for each");
  const auto row_of = [&](std::size_t i) { return rows.empty() ? first_row + i : rows[i]; };
  Index index;
  index.ends.resize(row_count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    if (row_of(i) >= row_count)
      throw Error(ErrorCode::bad_option, "row number " + std::to_string(row_of(i)) + " of " + std::to_string(i) +
                                             " in " + what + ": there are distances for " + std::to_string(row_count) +
                                             " rows");
    ++index.ends[row_of(i) + 1];
  }
  for (std::size_t f = 0; f < row_count; ++f) index.ends[f + 1] += index.ends[f];
  index.items.resize(count);
  // ends[f] is now where row f begins; filling it moves it to where the row ends.
  for (std::size_t i = 0; i < count; ++i) index.items[index.ends[row_of(i)]++] = static_cast<std::uint32_t>(i);
  return index;
}

RowShapes::RowShapes(const ShapeFeatures& features, std::size_t rows) : shapes_(features.shapes) {
  const std::size_t polygons = shapes_.regions.polygon_count(), lines = shapes_.lines.size();
  polygons_ = index_of(features.region_rows, polygons, 0, rows, "polygons");
  lines_ = index_of(features.line_rows, lines, polygons, rows, "lines");
  points_ = index_of(features.point_rows, shapes_.points.size(), polygons + lines, rows, "points");
}

RowShapes::Row RowShapes::row(std::size_t f) const {
  Row row;
  for (const std::uint32_t p : polygons_.of(f)) {
    const RegionView& regions = shapes_.regions;
    for (std::uint32_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c) {
      const std::span<const Point> contour = regions.contour(c);
      row.region_points.insert(row.region_points.end(), contour.begin(), contour.end());
      row.contour_ends.push_back(static_cast<std::uint32_t>(row.region_points.size()));
    }
    row.polygon_ends.push_back(static_cast<std::uint32_t>(row.contour_ends.size()));
  }
  for (const std::uint32_t l : lines_.of(f)) {
    const std::span<const Point> line = shapes_.lines[l];
    row.line_points.insert(row.line_points.end(), line.begin(), line.end());
    row.line_ends.push_back(static_cast<std::uint32_t>(row.line_points.size()));
  }
  for (const std::uint32_t p : points_.of(f)) row.points.push_back(shapes_.points[p]);
  return row;
}

}  // namespace oblast::internal::buffering
