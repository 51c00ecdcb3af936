// The active edge list: the bounds that the scan line crosses, from bottom to top.
//
//      |  slot 7 ______     A slot has a bound, its edge at the scan line and the winding numbers above it. The
//      |____/               slots are a doubly linked list, and a treap over it: a binary tree in the order of the
//      |  slot 3 ____       list and a heap by random priorities. So its expected depth is O(log n) for any input.
//      |                    Links are indices into one flat array, free slots are reused, and there is no
//      |  slot 0            recursion.
//
// Slot 0 is the ground, below everything, and the root of the tree; all others are right of it.
#pragma once

#include <oblast/point.h>

#include <cstdint>

#include "base/call_memory.h"
#include "engines/vatti/bounds.h"
#include "exact/orientation.h"

namespace oblast::internal::vatti {

using Slot = std::uint32_t;
inline constexpr Slot ground = 0;

struct ActiveEdge {
  Point a, b;            ///< the edge at the scan line; a is smaller
  std::uint32_t vertex;  ///< of b
  std::uint32_t step;    ///< from a vertex of the bound to the next
  std::uint32_t last;    ///< vertex at which the bound ends
  std::uint32_t top;     ///< stop at which the bound ends
  Winding above;         ///< winding numbers above the bound
};

class ActiveEdges {
 public:
  /// The vertices of bounds are read from `points` as the scan line moves.
  explicit ActiveEdges(std::span<const Point> points) : points_(points) {
    nodes_.push_back({});
    nodes_[ground].priority = std::numeric_limits<std::uint32_t>::max();
  }

  ActiveEdge& operator[](Slot slot) { return nodes_[slot].edge; }
  Slot above(Slot slot) const { return nodes_[slot].next; }  ///< `none` above the highest
  Slot below(Slot slot) const { return nodes_[slot].previous; }

  /// The highest active edge below p; the scan line is at p. REQUIRES: p is on no active edge.
  /// Cost: O(log n) expected, plus each vertex that the scan line has passed, once.
  Slot find_below(const Point& p);

  /// Inserts an edge directly above `slot`. Cost: O(1) expected.
  Slot insert_above(Slot slot, const ActiveEdge& edge);

  /// Cost: O(1) expected.
  void erase(Slot slot);

 private:
  struct Node {
    ActiveEdge edge;
    Slot parent = none, left = none, right = none;
    Slot previous = none, next = none;
    std::uint32_t priority = 0;
  };

  Slot new_slot();
  void rotate_up(Slot slot);
  void replace_child(Slot parent, Slot child, Slot by);

  std::span<const Point> points_;
  Array<Node> nodes_;
  Slot free_ = none;  ///< head of the list of free slots, linked by `next`
  std::uint32_t random_ = 0x9e3779b9;
};

}  // namespace oblast::internal::vatti
