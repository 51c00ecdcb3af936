// The auxiliary raster of `layers`.
#include "layers/raster_pyramid.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/index.h"
#include "plane/empty_box.h"

namespace oblast::internal {
namespace {

void extend(Box& box, const Box& by) {
  box = {std::min(box.x0, by.x0), std::min(box.y0, by.y0), std::max(box.x1, by.x1), std::max(box.y1, by.y1)};
}

}  // namespace

RasterPyramid::RasterPyramid(const Box& whole, std::size_t most)
    : x0_(whole.x0),
      y0_(whole.y0),
      side_(std::max(whole.x1 - whole.x0, whole.y1 - whole.y0)),
      // As many cells as boxes, and three more levels for crowded boxes.
      levels_(static_cast<std::uint32_t>(std::bit_width(most)) / 2 + 3),
      cells_(1, Cell{.box = empty_box}) {
  boxes_.reserve(most);
  next_box_.reserve(most);
}

std::uint32_t RasterPyramid::level_of(const Box& box) const {
  const double size = std::max(box.x1 - box.x0, box.y1 - box.y0);
  if (!(size < side_)) return 0;
  if (size <= std::ldexp(side_, -static_cast<int>(levels_))) return levels_;
  return static_cast<std::uint32_t>(std::ilogb(side_ / size));
}

std::uint32_t RasterPyramid::position(double centre, double origin) const {
  const double columns = std::ldexp(1.0, static_cast<int>(levels_));
  return static_cast<std::uint32_t>(std::clamp((centre - origin) / side_ * columns, 0.0, columns - 1));
}

void RasterPyramid::insert(const Box& box) {
  const auto number = static_cast<std::uint32_t>(boxes_.size());
  const std::uint32_t level = level_of(box);
  std::uint32_t column = 0, row = 0;
  if (level > 0) {
    column = position(box.x0 / 2 + box.x1 / 2, x0_);
    row = position(box.y0 / 2 + box.y1 / 2, y0_);
  }
  std::uint32_t cell = 0;
  extend(cells_[cell].box, box);
  for (std::uint32_t l = 1; l <= level; ++l) {
    const std::uint32_t shift = levels_ - l;
    const std::uint32_t quarter = (row >> shift & 1) << 1 | (column >> shift & 1);
    if (cells_[cell].children == none) {
      cells_[cell].children = checked_index(cells_.size(), "cells of the raster");
      cells_.resize(cells_.size() + 4, Cell{.box = empty_box});
    }
    cell = cells_[cell].children + quarter;
    extend(cells_[cell].box, box);
  }
  boxes_.push_back(box);
  next_box_.push_back(cells_[cell].first_box);
  cells_[cell].first_box = number;
}

}  // namespace oblast::internal
