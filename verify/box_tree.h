// A balanced tree of boxes: which of them meet a box, and which are near to a point.
#pragma once

#include <oblast/point.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace oblast::verify {

/// A closed box. The empty one holds nothing and can be extended.
struct Box {
  Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  Box() = default;
  Box(const Point& a, const Point& b)
      : low{std::min(a.x, b.x), std::min(a.y, b.y)}, high{std::max(a.x, b.x), std::max(a.y, b.y)} {}

  bool empty() const { return !(low.x <= high.x); }
  void add(const Box& b) {
    low = {std::min(low.x, b.low.x), std::min(low.y, b.low.y)};
    high = {std::max(high.x, b.high.x), std::max(high.y, b.high.y)};
  }
  bool meets(const Box& b) const {
    return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y;
  }
  /// At most the distance from p to the box, and nearly that.
  double distance(const Point& p) const {
    const double dx = std::max({low.x - p.x, 0.0, p.x - high.x}), dy = std::max({low.y - p.y, 0.0, p.y - high.y});
    return std::sqrt(dx * dx + dy * dy) * (1 - 0x1p-48);
  }
};

class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(std::vector<Box> boxes);

  /// Calls visit(item) for every box that meets `box`.
  template <class Visit>
  void meeting(const Box& box, const Visit& visit) const {
    if (!items_.empty()) meeting(0, 0, items_.size(), box, visit);
  }

  /// Calls visit(item) for every box that is not further from p than limit(), which may fall as items are visited. Near
  /// boxes come early.
  template <class Limit, class Visit>
  void near(const Point& p, const Limit& limit, const Visit& visit) const {
    if (!items_.empty()) near(0, 0, items_.size(), p, limit, visit);
  }

 private:
  static constexpr std::size_t leaf_size = 8;

  void build(std::size_t node, std::size_t begin, std::size_t end);

  template <class Visit>
  void meeting(std::size_t node, std::size_t begin, std::size_t end, const Box& box, const Visit& visit) const {
    if (!nodes_[node].meets(box)) return;
    if (end - begin <= leaf_size) {
      for (std::size_t k = begin; k < end; ++k)
        if (boxes_[items_[k]].meets(box)) visit(items_[k]);
      return;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    meeting(2 * node + 1, begin, middle, box, visit);
    meeting(2 * node + 2, middle, end, box, visit);
  }

  template <class Limit, class Visit>
  void near(std::size_t node, std::size_t begin, std::size_t end, const Point& p, const Limit& limit,
            const Visit& visit) const {
    if (nodes_[node].distance(p) > limit()) return;
    if (end - begin <= leaf_size) {
      for (std::size_t k = begin; k < end; ++k)
        if (boxes_[items_[k]].distance(p) <= limit()) visit(items_[k]);
      return;
    }
    const std::size_t middle = begin + (end - begin) / 2, first = 2 * node + 1, second = first + 1;
    const bool in_order = nodes_[first].distance(p) <= nodes_[second].distance(p);
    if (in_order) near(first, begin, middle, p, limit, visit);
    near(second, middle, end, p, limit, visit);
    if (!in_order) near(first, begin, middle, p, limit, visit);
  }

  std::vector<Box> boxes_;
  std::vector<std::uint32_t> items_;  ///< in the order of the leaves
  std::vector<Box> nodes_;            ///< the children of node k are 2 k + 1 and 2 k + 2
};

}  // namespace oblast::verify
