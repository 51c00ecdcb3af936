// Boxes along the rings of a polygon: a binary tree over pieces that get on in one direction, in the order in which
// they follow.
//
//   pieces  p0 p1 p2 p3 p4 p5 p6      of rings that stand one after another, each closed
//   boxes   [     ][     ][     ][]   of two
//           [            ][       ]   of four, and so on
//
// A piece does not meet itself, nor do pieces that follow one another in one direction. What follows along a ring lies
// near by in the plane, so the boxes fit well although nothing was sorted, and building them costs next to nothing.
// Where a ring wanders about, as stars do, they say little: then there is no answer within a stated number of looks,
// and the caller has other means.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <optional>
#include <span>

#include "base/call_memory.h"
#include "plane/box.h"

namespace oblast::internal {

class RingTree {
 public:
  /// Takes the place of what was built before. `ends`: by ring, past its last vertex, which is its first one again.
  /// REQUIRES: at least three vertices a ring, no two neighbours equal. Cost: linear.
  void build(std::span<const Point> points, std::span<const std::uint32_t> ends);

  /// Whether edges meet other than by following one another, be it of one ring or of two. Nothing where that takes more
  /// looks than so many a piece.
  std::optional<bool> edges_meet() const;

  /// By ring, whether it lies in an odd number of the others. Nothing where that takes too long.
  /// REQUIRES: edges do not meet.
  std::optional<Array<bool>> odd_depths() const;

 private:
  struct Leaf {
    std::uint32_t first;  ///< first edge
    std::uint32_t last;   ///< past the last edge, which is also the index of the last vertex
    std::uint32_t ring;
  };
  struct Pair {
    std::uint32_t level, i, j;
  };

  void add_leaves(std::uint32_t ring, std::uint32_t begin, std::uint32_t last);
  void add_levels();
  std::uint32_t size(std::uint32_t level) const {
    return static_cast<std::uint32_t>(level_begins_[level + 1] - level_begins_[level]);
  }
  const Box& box(std::uint32_t level, std::uint32_t i) const { return boxes_[level_begins_[level] + i]; }
  std::uint32_t begin(std::uint32_t ring) const { return ring == 0 ? 0 : ends_[ring - 1]; }
  std::size_t most_looks() const;

  bool get_on(std::uint32_t level, std::uint32_t i, std::uint32_t j) const;
  bool leaves_meet(std::uint32_t p, std::uint32_t q) const;
  bool edges_meet(std::uint32_t i, std::uint32_t j, std::uint32_t ring) const;
  std::optional<bool> is_odd(std::uint32_t ring, std::size_t& looks) const;
  bool left_crossings_are_odd(std::uint32_t first_leaf, std::uint32_t last_leaf, double y) const;
  bool left_crossings_are_odd(std::uint32_t leaf, const Point& p) const;

  std::span<const Point> points_;
  std::span<const std::uint32_t> ends_;
  Array<Leaf> leaves_;
  Array<std::uint32_t> first_leaves_;  ///< by ring, and past the last one
  Array<Box> boxes_;                   ///< level by level, leaves first
  Array<std::uint8_t> directions_;     ///< as boxes_: a bit for each in which all edges there get on
  Array<std::size_t> level_begins_;    ///< boxes may be twice as many as vertices
};

}  // namespace oblast::internal
