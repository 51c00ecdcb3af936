// A packed tree of boxes that may change: which of them come near a box.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "base/large_pages.h"
#include "base/tuning.h"
#include "plane/box.h"

namespace oblast::internal {

/// Boxes along a space-filling curve by their middles, a few to a node, level upon level.
class BoxTree {
 public:
  /// Cost: linear.
  explicit BoxTree(std::span<const Box> boxes);

  /// Calls visit(i) for the boxes i that meet `box` until it returns false; tells whether it never did.
  template <class Visit>
  bool for_each_near(const Box& box, const Visit& visit) const {
    return order_.empty() || visit_node(begins_.size() - 2, 0, box, visit);
  }

  /// What was box i is `box` from now on. What the levels above know of the old one stays, so the tree serves best
  /// where boxes grow or merge. Cost: O(log n).
  void replace(std::uint32_t i, const Box& box);

  /// Box i meets nothing any more.
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

  LargeArray<std::uint32_t> order_;  ///< by place along the curve
  LargeArray<std::uint32_t> place_;  ///< by box
  LargeArray<Box> boxes_;            ///< level by level, those along the curve first
  Array<std::size_t> begins_;        ///< by level, and past the last one
};

}  // namespace oblast::internal
