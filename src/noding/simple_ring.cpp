#include "noding/simple_ring.h"

#include <algorithm>
#include <atomic>
#include <numeric>

#include "base/call_memory.h"
#include "exact/orientation.h"
#include "noding/meetings.h"
#include "noding/monotone_runs.h"
#include "noding/strands.h"
#include "plane/smallest_vertex.h"

namespace oblast::internal {
namespace {

using exact::orientation;

/// By the search that noding uses, whatever the ring is like.
bool is_tangled_anyhow(std::span<const Point> closed_ring) {
  noding::Strands strand;
  strand.points.assign(closed_ring.begin(), closed_ring.end());
  strand.close_strand({}, noding::any_group);
  strand.flags.assign(strand.points.size(), 0);
  strand.flags.front() = strand.flags.back() = noding::closed_flag;
  if (!noding::find_meetings(strand, noding::Grouping::by_strand, {}).empty()) return true;
  return std::any_of(strand.flags.begin(), strand.flags.end(),
                     [](std::uint8_t f) { return (f & noding::node_flag) != 0; });
}

}  // namespace

// A ring that turns one way only and has one smallest and one largest vertex is convex and simple, if no neighbours are
// equal: those make no turn, and between two steps down they are no extreme either.
int convex_turn(std::span<const Point> ring) {
  const std::size_t n = ring.size();
  int turn = 0, extremes = 0;
  Point a = ring[n - 2], b = ring[n - 1];
  for (const Point& c : ring) {
    const int t = orientation(a, b, c);
    const bool extreme = lexicographically_less(a, b) != lexicographically_less(b, c);
    if (extreme && (t == 0 || ++extremes > 2)) return 0;
    if (t == 0 && b == c) return 0;
    if (t != 0) {
      if (turn == -t) return 0;
      turn = t;
    }
    a = b;
    b = c;
  }
  return turn;
}

int turn_at_smallest(std::span<const Point> ring) {
  const std::size_t n = ring.size(), smallest = smallest_vertex(ring).vertex;
  return orientation(ring[(smallest + n - 1) % n], ring[smallest], ring[(smallest + 1) % n]);
}

bool is_tangled(std::span<const Point> closed_ring, RingTree& tree) {
  const auto end = static_cast<std::uint32_t>(closed_ring.size());
  tree.build(closed_ring, std::span(&end, 1));
  const std::optional<bool> answer = tree.edges_meet();
  return answer ? *answer : is_tangled_anyhow(closed_ring);
}

RingShape ring_shape(std::span<const Point> ring) {
  int turn = convex_turn(ring);
  if (turn == 0) {
    Array<Point> closed;
    closed.reserve(ring.size() + 1);
    closed.assign(ring.begin(), ring.end());
    closed.push_back(ring[0]);
    RingTree tree;
    if (is_tangled(closed, tree)) return RingShape::tangled;
    turn = turn_at_smallest(ring);
  }
  return turn > 0 ? RingShape::counter_clockwise : RingShape::clockwise;
}

}  // namespace oblast::internal
