#include "plane/enclosing_boxes.h"

#include <algorithm>
#include <cmath>

#include "base/call.h"
#include "base/call_memory.h"
#include "base/counting_sort.h"
#include "base/tuning.h"

namespace oblast::internal {
namespace {

/// A grid with about one cell per point, and the points of each cell.
class PointGrid {
 public:
  PointGrid(const Box& around, std::span<const Point> points)
      : around_(around), side_(static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(points.size()))))) {
    ends_.resize(std::size_t{side_} * side_);
    counting_sort(ends_, points_, [&](const auto& visit) {
      for (std::uint32_t i = 0; i < points.size(); ++i) visit(cell(column(points[i].x), row(points[i].y)), i);
    });
  }

  // Both functions are monotone, so a point inside a box is in a cell between the cells of its corners.
  std::uint32_t column(double x) const { return place(x, around_.x0, around_.x1); }
  std::uint32_t row(double y) const { return place(y, around_.y0, around_.y1); }

  /// The points in the cells of a row from one column to another. These are consecutive.
  std::span<const std::uint32_t> points(std::uint32_t row, std::uint32_t first_column,
                                        std::uint32_t last_column) const {
    const std::uint32_t first = cell(first_column, row);
    const std::uint32_t begin = first == 0 ? 0 : ends_[first - 1];
    return std::span(points_).subspan(begin, ends_[cell(last_column, row)] - begin);
  }

 private:
  std::uint32_t place(double value, double low, double high) const {
    if (high <= low) return 0;
    return std::min(static_cast<std::uint32_t>((value - low) / (high - low) * side_), side_ - 1);
  }
  std::uint32_t cell(std::uint32_t column, std::uint32_t row) const { return row * side_ + column; }

  Box around_;
  std::uint32_t side_;
  Array<std::uint32_t> ends_;    ///< by cell
  Array<std::uint32_t> points_;  ///< by cell: the indices of its points
};

}  // namespace

Enclosure find_enclosing(std::span<const Box> boxes, std::span<const Point> points) {
  const std::size_t count = boxes.size();
  Enclosure found{Array<std::uint8_t>(count, 0), Array<std::uint8_t>(count, 0)};
  if (count < 2) return found;
  Box around = boxes[0];
  for (const Box& b : boxes) around = around.joined(b);
  const PointGrid grid(around, points);
  std::size_t looks = 0;
  Steps steps(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    steps();
    const Box& box = boxes[i];
    const std::uint32_t first_column = grid.column(box.x0), last_column = grid.column(box.x1);
    for (std::uint32_t row = grid.row(box.y0); row <= grid.row(box.y1); ++row) {
      const auto near = grid.points(row, first_column, last_column);
      looks += 1 + near.size();
      if (looks > tuning::looks_an_enclosing_box * count)
        return {Array<std::uint8_t>(count, 1), Array<std::uint8_t>(count, 1)};
      for (const std::uint32_t j : near) {
        if (j == i || !box.meets(Box::of(points[j], points[j]))) continue;
        found.encloses[i] = 1;
        found.enclosed[j] = 1;
      }
    }
  }
  return found;
}

}  // namespace oblast::internal
