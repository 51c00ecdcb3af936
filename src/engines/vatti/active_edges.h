// The active edge list: the bounds that the scan line crosses, from below to above.
//
//      |  slot 7 ______      A slot holds a bound, its edge under the scan line and the winding numbers
//      |____/               above it. The slots are a doubly linked list and, over it, a treap: a binary
//      |  slot 3 ____       tree in the list's order, a heap by random priorities, so that its depth is
//      |                    O(log n) whatever comes. Everything is an index into one flat array, slots are
//      |  slot 0            used again, nothing recurses.
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
  Point a, b;            ///< the edge under the scan line, a smaller
  std::uint32_t vertex;  ///< of b
  std::uint32_t step;    ///< from a vertex of the bound to the next
  std::uint32_t last;    ///< vertex where the bound finishes
  std::uint32_t top;     ///< stop where the bound finishes
  Winding above;         ///< winding numbers above the bound
};

class ActiveEdges {
 public:
  /// Vertices of bounds are read from `points` as the scan line moves on.
  explicit ActiveEdges(std::span<const Point> points) : points_(points) {
    nodes_.push_back({});
    nodes_[ground].priority = std::numeric_limits<std::uint32_t>::max();
  }

  ActiveEdge& operator[](Slot slot) { return nodes_[slot].edge; }
  Slot above(Slot slot) const { return nodes_[slot].next; }  ///< `none` above the highest
  Slot below(Slot slot) const { return nodes_[slot].previous; }

  /// The highest active edge below p, where the scan line stands. REQUIRES: p is on none of them.
  /// Cost: O(log n) expected, and the vertices the scan line has passed, each once.
  Slot find_below(const Point& p);

  /// Puts an edge directly above `slot`. Cost: O(1) expected.
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
  Slot free_ = none;  ///< head of the slots to use again, linked by `next`
  std::uint32_t random_ = 0x9e3779b9;
};

}  // namespace oblast::internal::vatti
