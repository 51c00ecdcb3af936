// The auxiliary raster of `layers`: finds the boxes, among those inserted before, that overlap a given box.
//
//    level 0 +-------+   level 1 +---+---+   level 2 +-+-+-+-+     A box is in the cell that contains its
//            |       |           |   |   |           +-+-+-+-+     centre, at the finest level whose cells
//            |       |           +---+---+           +-+-+-+-+     are not smaller than the box.
//            +-------+           +---+---+           +-+-+-+-+
//
// The paper has one raster, and fills all cells under a box. With boxes of very different sizes, that fills many cells
// many times. So this raster has several resolutions, and a box is in one cell of one of them. A cell stores the common
// box of everything in it and in the cells below it. So the search is exact, even though cells are computed with
// rounding.
#pragma once

#include <cstdint>

#include "base/call_memory.h"
#include "base/index.h"
#include "plane/box.h"

namespace oblast::internal {

/// True if the interiors of the two boxes have a point in common.
inline bool overlap(const Box& p, const Box& q) { return p.x0 < q.x1 && q.x0 < p.x1 && p.y0 < q.y1 && q.y0 < p.y1; }

class RasterPyramid {
 public:
  /// `whole` contains all boxes that will be inserted; `most` is approximately their number.
  RasterPyramid(const Box& whole, std::size_t most);

  /// Inserts a box. Its number is the number of boxes inserted before. Cost: O(log n).
  void insert(const Box& box);

  /// Calls visit(number) for each box that overlaps `box`. Cost: the number of cells that overlap it.
  template <class Visit>
  void for_each_overlapping(const Box& box, const Visit& visit) {
    pending_.assign(1, 0);
    while (!pending_.empty()) {
      const Cell& cell = cells_[pending_.back()];
      pending_.pop_back();
      if (!overlap(cell.box, box)) continue;
      for (std::uint32_t b = cell.first_box; b != none; b = next_box_[b])
        if (overlap(boxes_[b], box)) visit(b);
      if (cell.children == none) continue;
      for (std::uint32_t quarter = 0; quarter < 4; ++quarter) pending_.push_back(cell.children + quarter);
    }
  }

 private:
  struct Cell {
    Box box;  ///< of all boxes in it and in the cells below it
    std::uint32_t first_box = none;
    std::uint32_t children = none;  ///< the first of its four quarters, which lie side by side
  };

  std::uint32_t level_of(const Box& box) const;
  /// The column or row of a centre, at the finest level.
  std::uint32_t position(double centre, double origin) const;

  double x0_, y0_, side_;
  std::uint32_t levels_;  ///< the finest level has 2^levels_ columns and rows
  Array<Cell> cells_;
  Array<Box> boxes_;
  Array<std::uint32_t> next_box_;  ///< by box: the next in its cell
  Array<std::uint32_t> pending_;
};

}  // namespace oblast::internal
