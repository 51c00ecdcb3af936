// Shortest first, edges grow evenly: of n vertices that one edge got back, half go in edges of two pieces, a quarter in
// edges of four. So although the box of a long slanting edge holds much that is not near it, few edges are long, and
// all together look at O(n) others and not at n each.
#include "overlay/retry_traces.h"

#include <queue>

#include "noding/box_tree.h"
#include "overlay/edge_conflict.h"

namespace oblast {
namespace {

using noding::Box;

/// The vertices along their rings.
struct Links {
  Array<std::uint32_t> before, after;

  explicit Links(const Rings& rings) : before(rings.points.size()), after(rings.points.size()) {
    for (std::size_t r = 0; r < rings.size(); ++r) {
      for (std::uint32_t v = rings.begin(r); v < rings.ends[r]; ++v) {
        before[v] = rings.before(r, v);
        after[v] = rings.after(r, v);
      }
    }
  }

  void take_out(std::uint32_t v) {
    after[before[v]] = after[v];
    before[after[v]] = before[v];
  }
};

class Retry {
 public:
  explicit Retry(Rings& rings)
      : rings_(rings), links_(rings), waits_(rings.points.size(), 0), queue_(Later{rings.points}), tree_(reach()) {}

  /// Flags what is to be taken out as trace.
  void run() {
    for (std::uint32_t v = 0; v < rings_.points.size(); ++v) push(v);
    while (!queue_.empty()) {
      const Candidate candidate = queue_.top();
      queue_.pop();
      const std::uint32_t v = candidate.vertex;
      if (!waits_[v] || candidate != candidate_of(v)) continue;  // tried since, or waits with another edge
      waits_[v] = 0;
      if (!is_needed(v)) take_out(v);
    }
  }

 private:
  struct Candidate {
    double length;  ///< of the edge in its place, squared
    std::uint32_t vertex;
    bool operator==(const Candidate&) const = default;
  };

  struct Later {
    const LargeArray<Point>& points;
    bool operator()(const Candidate& p, const Candidate& q) const {
      if (p.length != q.length) return p.length > q.length;
      return lexicographically_less(points[q.vertex], points[p.vertex]);
    }
  };

  LargeArray<Box> reach() const {
    LargeArray<Box> boxes(rings_.points.size());
    for (std::uint32_t v = 0; v < boxes.size(); ++v) boxes[v] = reach_of(v);
    return boxes;
  }

  bool is_restored(std::uint32_t v) const { return (rings_.flags[v] & restored_vertex) != 0; }

  /// Of the edge that starts at v; and if v may go, of all that its going changes.
  Box reach_of(std::uint32_t v) const {
    const Box edge = Box::of(rings_.points[v], rings_.points[links_.after[v]]);
    return is_restored(v) ? edge.joined(rings_.points[links_.before[v]]) : edge;
  }

  Candidate candidate_of(std::uint32_t v) const {
    const Point &a = rings_.points[links_.before[v]], &c = rings_.points[links_.after[v]];
    return {(c.x - a.x) * (c.x - a.x) + (c.y - a.y) * (c.y - a.y), v};
  }

  void push(std::uint32_t v) {
    if (!is_restored(v) || waits_[v]) return;
    waits_[v] = 1;
    queue_.push(candidate_of(v));
  }

  void take_out(std::uint32_t v) {
    const Box changed = reach_of(v);
    const std::uint32_t before = links_.before[v], after = links_.after[v];
    rings_.flags[v] = trace_vertex;
    links_.take_out(v);
    tree_.remove(v);
    for (const std::uint32_t neighbour : {before, after}) {
      tree_.replace(neighbour, reach_of(neighbour));
      waits_[neighbour] = 0;
    }
    // What it was in the way of.
    tree_.for_each_near(changed, [&](std::uint32_t w) {
      push(w);
      return true;
    });
  }

  /// Whether the rest of the result is in the way of an edge from the vertex before v to the one after it.
  bool is_needed(std::uint32_t v) const {
    const std::uint32_t first = links_.before[v], last = links_.after[v];
    const Point &a = rings_.points[first], &b = rings_.points[v], &c = rings_.points[last];
    const Box box = Box::of(a, c), swept = reach_of(v);
    const auto lies_between = [&](const Point& p) {
      if (p == a || p == b || p == c) return false;
      PointInRing query(p);
      query.add_edge(a, b);
      query.add_edge(b, c);
      query.add_edge(c, a);
      return query.is_inside();
    };
    return !tree_.for_each_near(swept, [&](std::uint32_t e) {
      if (e == first || e == v) return true;
      const Point &p = rings_.points[e], &q = rings_.points[links_.after[e]];
      const Box edge = Box::of(p, q);
      if (!edge.meets(swept)) return true;
      return !(edge.meets(box) && in_conflict(a, c, p, q)) && !lies_between(p) && !lies_between(q);
    });
  }

  Rings& rings_;
  Links links_;
  Array<std::uint8_t> waits_;  ///< by vertex: its newest candidate is in the queue
  std::priority_queue<Candidate, Array<Candidate>, Later> queue_;
  noding::BoxTree tree_;  ///< by vertex: what it reaches
};

}  // namespace

Rings retry_traces(Rings rings) {
  Retry(rings).run();
  return without(rings, trace_vertex);
}

}  // namespace oblast
