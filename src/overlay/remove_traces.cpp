// Edges that cancel leave nothing behind (promise G3a).
//
//   a ----- t ----- t ----- b        t: trace vertices, pieces of one input edge
//   a --------------------- b        the straightened edge, kept if it meets nothing else
//
// All straightened edges are tried at once; those that meet another edge of the result other than at an
// end, or that would pass over a vertex of it, get their vertices back, all at once, until none does. Where two were in
// each other's way both did: what came back is tried again one by one (retry_traces.h). So the outcome is a function of
// the result alone, promise G2 holds, and no vertex stays that could go.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "exact/orientation.h"
#include "memory/call_memory.h"
#include "noding/pair_finder.h"
#include "overlay/edge_conflict.h"
#include "overlay/retry_traces.h"
#include "overlay/rings.h"

namespace oblast {
namespace {

using exact::orientation;
using noding::Strands;

/// The rings as closed strands without the vertices flagged `drop`; `from` is by vertex of the strands.
struct Straightened {
  Strands strands;
  Array<std::uint32_t> from;  ///< index in the rings
};

Straightened straighten(const Rings& rings) {
  Straightened s;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const std::uint32_t begin = rings.begin(r), end = rings.ends[r];
    const auto traced = [&](std::uint32_t v) { return (rings.flags[v] & trace_vertex) != 0; };
    std::uint32_t first = begin;
    while (first < end && traced(first)) ++first;  // a ring always has vertices of the input
    std::uint32_t v = first;
    do {
      const bool is_traced = traced(v);
      if (!is_traced) {
        s.strands.points.push_back(rings.points[v]);
        s.strands.flags.push_back(0);
        s.from.push_back(v);
      } else {
        s.strands.flags.back() = noding::moved_flag;
      }
      v = rings.after(r, v);
    } while (v != first);
    s.strands.points.push_back(rings.points[first]);
    s.strands.flags.push_back(0);
    s.from.push_back(first);
    s.strands.close_strand({}, noding::any_group);
  }
  return s;
}

/// Finds the straightened edges in conflict with the rest of the result.
class ConflictFinder {
 public:
  ConflictFinder(const Rings& rings, const Straightened& straightened)
      : rings_(rings),
        s_(straightened),
        points_(straightened.strands.points),
        detour_of_(points_.size()),
        conflict_(points_.size(), 0) {
    for (std::uint32_t e = 0; e < points_.size(); ++e) {
      if (!is_straightened(e)) continue;
      detour_of_[e] = static_cast<std::uint32_t>(detours_.size());
      detours_.push_back(detour(e));
      conflict_[e] = detours_.back().leaves_box;
    }
  }

  /// By the index of the edge's first vertex in the rings.
  Array<std::uint32_t> run() {
    const auto visit = [&](std::span<const noding::RunPair> pairs) {
      for (const noding::RunPair& pair : pairs) {
        for (std::uint32_t i = pair.first_p; i < pair.last_p; ++i) {
          const noding::Box box = box_of(i);
          for (std::uint32_t j = pair.first_q; j < pair.last_q; ++j)
            if (box.meets(box_of(j))) test(i, j);
        }
      }
    };
    // What an edge passes over it need not meet.
    noding::find_pairs(points_, runs(), visit, noding::PairGoal::boxes);
    Array<std::uint32_t> found;
    for (std::uint32_t e = 0; e < conflict_.size(); ++e)
      if (conflict_[e]) found.push_back(s_.from[e]);
    return found;
  }

 private:
  bool is_straightened(std::uint32_t edge) const { return (s_.strands.flags[edge] & noding::moved_flag) != 0; }
  noding::Box box_of(std::uint32_t edge) const { return noding::Box::of(points_[edge], points_[edge + 1]); }

  /// Each straightened edge is a run of its own, so that it is tested against its neighbours too.
  LargeArray<noding::Run> runs() const {
    LargeArray<noding::Run> single;
    for (const noding::Run& run : noding::monotone_runs(s_.strands, noding::Grouping::by_moved)) {
      if (run.group != noding::any_group) {
        single.push_back({run.box, run.first, run.last, run.group});
        continue;
      }
      for (std::uint32_t e = run.first; e < run.last; ++e) single.push_back({box_of(e), e, e + 1, run.group});
    }
    return single;
  }

  void test(std::uint32_t i, std::uint32_t j) {
    if (in_conflict(points_[i], points_[i + 1], points_[j], points_[j + 1])) {
      set(i);
      set(j);
      return;
    }
    if (passes_over_end(i, j)) set(i);
    if (passes_over_end(j, i)) set(j);
  }

  void set(std::uint32_t edge) {
    if (is_straightened(edge)) std::atomic_ref(conflict_[edge]).store(1, std::memory_order_relaxed);
  }

  bool passes_over_end(std::uint32_t edge, std::uint32_t other) const {
    if (!is_straightened(edge)) return false;
    for (const Point& p : {points_[other], points_[other + 1]})
      if (p != points_[edge] && p != points_[edge + 1] && passes_over(edge, p)) return true;
    return false;
  }

  /// Calls visit for the vertices from the edge's first to its last, those taken out included.
  template <class Visit>
  void for_each_vertex(std::uint32_t edge, const Visit& visit) const {
    const std::uint32_t from = s_.from[edge], to = s_.from[edge + 1];
    const std::size_t ring = rings_.ring_of(from);
    std::uint32_t v = from;
    do {
      visit(rings_.points[v]);
      v = rings_.after(ring, v);
    } while (v != to);
    visit(rings_.points[to]);
  }

  /// How far the pieces that a straightened edge replaces go to its right (negative) and left, times its length.
  struct Detour {
    double least, most;
    bool leaves_box;  ///< of the edge, by which the pieces are looked for: so they must not
  };

  double offset(std::uint32_t edge, const Point& p) const {
    const Point &a = points_[edge], &b = points_[edge + 1];
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  }

  Detour detour(std::uint32_t edge) const {
    Detour d{0, 0, false};
    const noding::Box box = box_of(edge);
    for_each_vertex(edge, [&](const Point& v) {
      const double at = offset(edge, v);
      d.least = std::min(d.least, at);
      d.most = std::max(d.most, at);
      d.leaves_box |= !box.contains(v);
    });
    // In the edge's box the offset of a piece's end, and that of the point it is compared with, are off by at most four
    // epsilons of this product each. Nothing under- or overflows in the domain of coordinates.
    const Point &a = points_[edge], &b = points_[edge + 1];
    const double error = 16 * std::numeric_limits<double>::epsilon() * std::fabs((b.x - a.x) * (b.y - a.y));
    d.least -= error;
    d.most += error;
    return d;
  }

  /// p lies between the straightened edge and the pieces it replaces. These can be many, so box and detour are asked
  /// first. REQUIRES: the pieces do not leave the edge's box.
  bool passes_over(std::uint32_t edge, const Point& p) const {
    const double at = offset(edge, p);
    const Detour& d = detours_[detour_of_[edge]];
    if (!box_of(edge).meets(noding::Box::of(p, p)) || at < d.least || at > d.most) return false;
    PointInRing query(p);
    const Point* before = nullptr;
    for_each_vertex(edge, [&](const Point& v) {
      if (before) query.add_edge(*before, v);
      before = &v;
    });
    query.add_edge(points_[edge + 1], points_[edge]);
    return query.is_inside();
  }

  const Rings& rings_;
  const Straightened& s_;
  const LargeArray<Point>& points_;
  LargeArray<std::uint32_t> detour_of_;  ///< by edge, of those straightened
  Array<Detour> detours_;
  Array<std::uint8_t> conflict_;  ///< by edge
};

/// Gives the trace vertices after `vertex` back, up to the next that stays.
void restore_after(Rings& rings, std::uint32_t vertex) {
  const std::size_t ring = rings.ring_of(vertex);
  for (std::uint32_t v = vertex;;) {
    v = rings.after(ring, v);
    if (!(rings.flags[v] & trace_vertex)) return;
    rings.flags[v] = static_cast<std::uint8_t>((rings.flags[v] & ~trace_vertex) | restored_vertex);
  }
}

}  // namespace

Rings remove_traces(Rings rings, CollinearVertices collinear) {
  const auto has = [&](RingVertex bit) {
    return std::any_of(rings.flags.begin(), rings.flags.end(), [&](std::uint8_t f) { return (f & bit) != 0; });
  };
  while (has(trace_vertex)) {
    const Straightened straightened = straighten(rings);
    const Array<std::uint32_t> conflicts = ConflictFinder(rings, straightened).run();
    for (const std::uint32_t vertex : conflicts) restore_after(rings, vertex);
    if (conflicts.empty()) rings = without(rings, trace_vertex);
  }
  if (has(restored_vertex)) rings = retry_traces(std::move(rings));
  if (collinear == CollinearVertices::drop) {
    // Collinear with both neighbours is collinear with the vertices that stay on either side.
    rings = without_if(rings, [&](std::size_t r, std::uint32_t v) {
      const std::uint32_t begin = rings.begin(r), last = rings.ends[r] - 1;
      const Point& before = rings.points[v == begin ? last : v - 1];
      const Point& after = rings.points[v == last ? begin : v + 1];
      return !(rings.flags[v] & touch_vertex) && orientation(before, rings.points[v], after) == 0;
    });
  }
  return rings;
}

}  // namespace oblast
