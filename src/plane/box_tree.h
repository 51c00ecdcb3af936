// A packed tree of boxes that may change. It finds the boxes that meet a given box.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "base/large_pages.h"
#include "base/tuning.h"
#include "plane/box.h"

namespace oblast::internal {

/// Boxes are sorted along a space-filling curve by their centres. A node has a few boxes or nodes of the level below.
class BoxTree {
 public:
  /// Cost: linear.
  explicit BoxTree(std::span<const Box> boxes);

  /// Calls visit(i) for the boxes i that meet `box`, until it returns false. Returns true if it never did.
  template <class Visit>
  bool for_each_near(const Box& box, const Visit& visit) const {
    return order_.empty() || visit_node(begins_.size() - 2, 0, box, visit);
  }

  /// Replaces box i by `box`. The nodes above still contain the old box, so the tree works best if boxes grow or merge.
  /// Cost: O(log n).
  void replace(std::uint32_t i, const Box& box);

  /// Removes box i.
  void remove(std::uint32_t i);

 private:
  static constexpr std::size_t fan = tuning::box_tree_fan;

  template <class Visit>
  bool visit_node(std::size_t level, std::size_t place, const Box& box, const Visit& visit) const {
    if (!boxes_[begins_[level] + place].meets(box)) return true;
    if (level == 0) return visit(order_[place]);
    const std::size_t size_below = begins_[level] - begins_[level - 1];
    for (std::size_t i = place * fan; i < std::min(size_below, (place + 1) * fan); ++i)
      if (!visit_node(level - 1, i, box, visit)) return false;
    return true;
  }

  LargeArray<std::uint32_t> order_;  ///< by place along the curve: the box
  LargeArray<std::uint32_t> place_;  ///< by box: its place along the curve
  LargeArray<Box> boxes_;            ///< by level; the boxes along the curve are the first level
  Array<std::size_t> begins_;        ///< by level: its beginning; and the end of the last one
};

}  // namespace oblast::internal
