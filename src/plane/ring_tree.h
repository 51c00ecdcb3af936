// Boxes along the rings of a polygon: a binary tree over consecutive pieces, each monotone in some direction.
//
//   pieces  p0 p1 p2 p3 p4 p5 p6      of consecutive closed rings
//   boxes   [     ][     ][     ][]   of two pieces
//           [            ][       ]   of four pieces, and so on
//
// A piece does not meet itself, nor do consecutive pieces that are monotone in the same direction. Consecutive pieces
// are close in the plane, so the boxes are small although nothing was sorted, and building them costs little. If a ring
// winds a lot, as stars do, the boxes exclude little. Then there is no answer within a given number of comparisons, and
// the caller must find it in another way.
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
  /// Builds the tree, and replaces the one before. `ends`: by ring, the end of its vertices; the last vertex repeats
  /// the first. REQUIRES: each ring has at least three vertices, and no two neighbours are equal. Cost: linear.
  void build(std::span<const Point> points, std::span<const std::uint32_t> ends);

  /// True if edges meet (of one ring or of two), except consecutive edges at their common vertex. Nothing if the
  /// decision takes more than a given number of comparisons per piece.
  std::optional<bool> edges_meet() const;

  /// For each ring, whether an odd number of the others contain it. Nothing if that takes too long. REQUIRES: edges do
  /// not meet.
  std::optional<Array<bool>> odd_depths() const;

 private:
  struct Leaf {
    std::uint32_t first;  ///< first edge
    std::uint32_t last;   ///< the end of its edges; also the index of the last vertex
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

  bool are_monotone(std::uint32_t level, std::uint32_t i, std::uint32_t j) const;
  bool leaves_meet(std::uint32_t p, std::uint32_t q) const;
  bool edges_meet(std::uint32_t i, std::uint32_t j, std::uint32_t ring) const;
  std::optional<bool> is_odd(std::uint32_t ring, std::size_t& looks) const;
  bool left_crossings_are_odd(std::uint32_t first_leaf, std::uint32_t last_leaf, double y) const;
  bool left_crossings_are_odd(std::uint32_t leaf, const Point& p) const;

  std::span<const Point> points_;
  std::span<const std::uint32_t> ends_;
  Array<Leaf> leaves_;
  Array<std::uint32_t> first_leaves_;  ///< by ring: its first leaf; and the end of the last one
  Array<Box> boxes_;                   ///< by level, leaves first
  Array<std::uint8_t> directions_;     ///< for each box: a bit for each direction along which all its edges advance
  Array<std::size_t> level_begins_;    ///< there may be twice as many boxes as vertices
};

}  // namespace oblast::internal
