// The overlay of contours with a convex window at the cost of what comes near the window.
//
//              A  .----.         Along the window's perimeter, counter-clockwise, the inside of A ends where its
//         .------x------x----.   boundary, directed with the inside on the left, enters the window, and begins where
//         |  .--'   ..   `-. |   it leaves. So the paths of A inside the window close along the perimeter, from where
//         |  |    A         ||   one leaves to the next crossing; for the union those outside do, and for the
//         |   `-.  ..  .---' |   difference those outside do, back to the crossing before.
//         `------x----x------'
//              `--'  W
//
// Only general position is handled, and recognised exactly: crossings are proper, everything keeps further than
// the gap of clearance.h from what is rounded, and where A's edges count they meet nothing but their neighbours.
// All else is declined, and left to the settled noding of `overlay`. So what is answered has the bytes of `overlay`.
//
// What does not count is not looked at closely. Let the *reach* be the box of all edges that come near the window.
// Of edges that stay outside the reach only the parity of crossings of a ray from the window's first corner is taken:
// noding may cut such an edge, but its pieces stay in its box (docs/guarantees.md), so out of the reach.
#pragma once

#include <oblast/options.h>
#include <oblast/region_set.h>

#include <cstdint>
#include <memory_resource>
#include <optional>
#include <vector>

#include "base/tuning.h"
#include "window/window.h"

namespace oblast::internal::window {

/// What is known of the subject: a convex contour needs no look at its own edges.
enum class SubjectKind { any, convex };

/// Cost: linear for a convex contour, a few vertices for most others.
SubjectKind kind_of(const RegionView& operand);

/// Scratch memory that small calls need no more than; it may lie on the stack.
inline constexpr std::size_t scratch_bytes = tuning::window_scratch_bytes;

class WindowClip {
 public:
  /// REQUIRES: `subject` validated; read by the rule `polygons`. Scratch memory is taken from `memory`.
  WindowClip(const RegionView& subject, SubjectKind kind, const Window& window, std::pmr::memory_resource* memory);

  /// subject op window, canonical; nothing when declined. REQUIRES: intersection, or a convex subject and union or
  /// difference. Cost: O(n + c log c), c edges near the window; for a small c just O(n).
  std::optional<RegionSet> run(Operation operation, RegionSet* spare = nullptr);

  std::size_t crossing_count() const { return crossings_.size(); }

 private:
  using Index = std::uint32_t;

  struct Ring {
    std::span<const Point> points;
    Index offset;  ///< of its first point in the subject's
    Index polygon;
    Index first_block;
    Index first_crossing = 0, end_crossing = 0;
    bool inside = false;  ///< all of it, in the window

    Index size() const { return static_cast<Index>(points.size()); }
    Index after(Index i) const { return i + 1 == size() ? 0 : i + 1; }
    const Point& from(Index edge) const { return points[edge]; }
    const Point& to(Index edge) const { return points[after(edge)]; }
  };
  /// Edges [first, last) of a ring, near the window. Core: they count in the result.
  struct Stretch {
    Index ring, first, last;
    bool core;
  };
  struct Crossing {
    Point at;
    Index side, ring, edge;
    bool enters;         ///< the window, as the ring is given
    bool inside_ends;    ///< seen along the perimeter
    bool done = false;   ///< its path is part of the result
    Index position = 0;  ///< along the perimeter
  };

  static bool is_inside(const Ring& ring) { return ring.inside; }

  // window_scan.cpp
  void measure();
  bool find_reach(Operation operation);
  void count_parity(const Ring& ring, Index first, Index last);
  bool walk();
  bool walk_block(Index ring, Index first, Index last, bool& inside);
  bool cross_window(Index ring, Index edge);
  bool is_clear_at(const Point& x, Index side, const Ring& ring, Index edge) const;

  // window_clear.cpp
  bool core_is_clear() const;
  bool every_pair_is_clear() const;
  bool edge_is_clear(const Ring& a, Index i, const Ring& b, Index first, Index last) const;
  bool pair_is_clear(const Ring& a, Index i, const Ring& b, Index j) const;

  // window_near_pairs.cpp
  class NearPairs;
  bool near_pairs_are_clear() const;

  // window_join.cpp
  bool order_along_perimeter();
  void join(Operation operation, RegionSet& result);
  void add_path(const Crossing& from, bool forward, const Crossing& to, RegionSet& result) const;
  void add_perimeter(const Crossing& from, const Crossing& to, bool forward, RegionSet& result) const;
  void add_uncrossed(RegionSet& result);
  void add_uncrossed_pair(Operation operation, RegionSet& result);
  void add_ring(const Ring& ring, bool counter_clockwise, RegionSet& result);
  void add_window(bool counter_clockwise, Index polygon, RegionSet& result);
  void end_contour(Index polygon, RegionSet& result);
  std::optional<RegionSet> finish(Operation operation, RegionSet result) const;

  static constexpr Index block_size = tuning::window_edges_a_block;

  RegionView subject_;
  SubjectKind kind_;
  const Window& window_;
  std::pmr::vector<Ring> rings_;
  std::pmr::vector<Box> blocks_;           ///< boxes of block_size edges each, ring by ring
  std::pmr::vector<std::uint8_t> covers_;  ///< by polygon: its parity at the window's first corner
  double gap_ = 0;
  Box reach_{};
  std::pmr::vector<Stretch> stretches_;
  std::pmr::vector<Crossing> crossings_;  ///< ring by ring, in the order of the ring
  std::pmr::vector<Index> perimeter_;     ///< crossings in their order along the perimeter
  std::pmr::vector<Index> polygons_;      ///< by contour of the result: the polygon that it bounds
};

}  // namespace oblast::internal::window
