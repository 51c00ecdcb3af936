#include "overlay/simple_ring.h"

#include <algorithm>
#include <atomic>
#include <numeric>

#include "exact/orientation.h"
#include "noding/meetings.h"
#include "noding/monotone_runs.h"
#include "noding/strands.h"

namespace oblast {
namespace {

using exact::orientation;

// Below this, testing every pair of edges is quicker than setting up a search.
constexpr std::size_t small_ring = 24;

/// Closed segments: true when they share any point.
bool edges_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (!noding::Box::of(a, b).meets(noding::Box::of(c, d))) return false;
  if (orientation(a, b, c) * orientation(a, b, d) > 0) return false;
  return orientation(c, d, a) * orientation(c, d, b) <= 0;
}

/// u -- v -- w folds back onto itself.
bool folds(const Point& u, const Point& v, const Point& w) {
  return lexicographically_less(u, v) != lexicographically_less(v, w) && orientation(u, v, w) == 0;
}

bool small_ring_is_simple(std::span<const Point> ring) {
  const std::size_t n = ring.size();
  const auto at = [&](std::size_t i) -> const Point& { return ring[i < n ? i : i - n]; };
  for (std::size_t i = 0; i < n; ++i) {
    if (folds(at(i), at(i + 1), at(i + 2))) return false;
    for (std::size_t j = i + 2; j < n && j - i < n - 1; ++j)
      if (edges_meet(ring[i], at(i + 1), ring[j], at(j + 1))) return false;
  }
  return true;
}

bool large_ring_is_simple(std::span<const Point> ring) {
  noding::Strands strand;
  strand.points.reserve(ring.size() + 1);
  strand.points.assign(ring.begin(), ring.end());
  strand.points.push_back(ring[0]);
  strand.close_strand({}, noding::any_group);
  strand.flags.assign(strand.points.size(), 0);
  strand.flags.front() = strand.flags.back() = noding::closed_flag;
  auto runs = noding::monotone_runs(strand, noding::Grouping::by_strand);
  if (!noding::find_meetings(strand, std::move(runs), {}).empty()) return false;
  return std::none_of(strand.flags.begin(), strand.flags.end(),
                      [](std::uint8_t f) { return (f & noding::node_flag) != 0; });
}

}  // namespace

// A ring that turns one way only and has one smallest and one largest vertex is convex and simple.
int convex_turn(std::span<const Point> ring) {
  const std::size_t n = ring.size();
  int turn = 0, extremes = 0;
  Point a = ring[n - 2], b = ring[n - 1];
  for (const Point& c : ring) {
    const int t = orientation(a, b, c);
    const bool extreme = lexicographically_less(a, b) != lexicographically_less(b, c);
    if (extreme && (t == 0 || ++extremes > 2)) return 0;
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
  const auto smallest =
      static_cast<std::size_t>(std::min_element(ring.begin(), ring.end(), lexicographically_less) - ring.begin());
  const std::size_t n = ring.size();
  return orientation(ring[(smallest + n - 1) % n], ring[smallest], ring[(smallest + 1) % n]);
}

RingShape ring_shape(std::span<const Point> ring) {
  int turn = convex_turn(ring);
  if (turn == 0) {
    const bool simple = ring.size() <= small_ring ? small_ring_is_simple(ring) : large_ring_is_simple(ring);
    if (!simple) return RingShape::tangled;
    turn = turn_at_smallest(ring);
  }
  return turn > 0 ? RingShape::counter_clockwise : RingShape::clockwise;
}

}  // namespace oblast
