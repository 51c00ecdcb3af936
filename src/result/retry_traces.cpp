// The vertex with the shortest new edge is removed first, so edges grow evenly: of n vertices of a span, the first half
// is replaced by edges of two pieces, the next quarter by edges of four. So few edges are long, and each vertex near
// them is tested O(log n) times.
#include "result/retry_traces.h"

#include <algorithm>
#include <queue>
#include <utility>

#include "base/parallel.h"
#include "noding/along.h"
#include "noding/monotone_runs.h"

namespace oblast::internal {
namespace {

class Retry {
 public:
  Retry(const TraceSpans& spans, const Array<bool>& refused, const Array<NearVertex>& near, Array<bool>& gone)
      : spans_(spans),
        rings_(spans.rings),
        gone_(gone),
        before_(rings_.points.size()),
        after_(rings_.points.size()),
        waits_(rings_.points.size(), false),
        counts_(spans.members.size()),
        queue_(Later{rings_.points}) {
    link();
    find_touches();
    for (std::size_t m = 0; m < counts_.size(); ++m)
      counts_[m] = refused[spans.members[m].span] && spans.spans[spans.members[m].span].is_monotone;
    sort_near(refused, near);
  }

  void run() {
    for (const SpanMember& member : spans_.members) push(member.vertex);
    Steps steps;
    while (!queue_.empty()) {
      steps();
      const Candidate candidate = queue_.top();
      queue_.pop();
      const std::uint32_t v = candidate.vertex;
      if (!waits_[v] || candidate != candidate_of(v)) continue;  // tried since, or in the queue with another edge
      waits_[v] = false;
      if (may_go(v)) take_out(v);
    }
  }

 private:
  struct Candidate {
    double length;  ///< squared length of the edge that replaces the vertex
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

  /// Links the vertices that remain so far, along their rings. A removed vertex is linked to the remaining one before
  /// it, an end of an open path to itself.
  void link() {
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      const std::uint32_t begin = rings_.begin(r), end = rings_.ends[r];
      std::uint32_t last = end;
      do --last;
      while (gone_[last]);
      std::uint32_t previous = rings_.is_open(r) ? begin : last;
      for (std::uint32_t v = begin; v < end; ++v) {
        before_[v] = previous;
        if (gone_[v]) continue;
        after_[previous] = v;
        previous = v;
      }
      if (rings_.is_open(r)) after_[last] = last;
    }
  }

  /// Finds the vertices at which contours touch. Vertices at the same point are adjacent.
  void find_touches() {
    for (std::uint32_t v = 0; v < rings_.points.size(); ++v)
      if (rings_.flags[v] & touch_vertex) touches_.push_back(v);
    parallel_sort(touches_.begin(), touches_.end(), [&](std::uint32_t v, std::uint32_t w) { return less(v, w); });
  }

  bool less(std::uint32_t v, std::uint32_t w) const {
    return lexicographically_less(rings_.points[v], rings_.points[w]);
  }

  /// Sorts by span and along it; and, for each vertex, the spans near it.
  void sort_near(const Array<bool>& refused, const Array<NearVertex>& near) {
    for (const NearVertex& n : near)
      if (refused[n.span] && !gone_[n.vertex]) near_.push_back(n);
    parallel_sort(near_.begin(), near_.end(), [&](const NearVertex& p, const NearVertex& q) {
      if (p.span != q.span) return p.span < q.span;
      const TraceSpan& span = spans_.spans[p.span];
      const noding::Along along(spans_.point(span, 0), spans_.point(span, span.count + 1));
      return along(rings_.points[p.vertex], rings_.points[q.vertex]);
    });
    by_vertex_.reserve(near_.size());
    for (std::uint32_t i = 0; i < near_.size(); ++i)
      if (is_candidate(near_[i].vertex)) by_vertex_.push_back(i);
    parallel_sort(by_vertex_.begin(), by_vertex_.end(), [&](std::uint32_t i, std::uint32_t j) {
      return near_[i].vertex != near_[j].vertex ? near_[i].vertex < near_[j].vertex : i < j;
    });
  }

  /// The index of the first member of a vertex that counts. If none does, the index of another vertex's member, or the
  /// end.
  std::size_t member_of(std::uint32_t v) const {
    const auto& members = spans_.members;
    const auto it = std::lower_bound(members.begin(), members.end(), v,
                                     [](const SpanMember& m, std::uint32_t vertex) { return m.vertex < vertex; });
    auto m = static_cast<std::size_t>(it - members.begin());
    while (is_of(m, v) && !counts_[m]) ++m;
    return m;
  }
  bool is_of(std::size_t m, std::uint32_t v) const { return m < counts_.size() && spans_.members[m].vertex == v; }

  bool is_candidate(std::uint32_t v) const { return !gone_[v] && is_of(member_of(v), v); }

  Candidate candidate_of(std::uint32_t v) const {
    const Point &a = rings_.points[before_[v]], &c = rings_.points[after_[v]];
    return {(c.x - a.x) * (c.x - a.x) + (c.y - a.y) * (c.y - a.y), v};
  }

  void push(std::uint32_t v) {
    if (!is_candidate(v) || waits_[v]) return;
    waits_[v] = true;
    queue_.push(candidate_of(v));
  }

  bool may_go(std::uint32_t v) const {
    const std::uint32_t first = before_[v], last = after_[v];
    if (has_edge(first, last)) return false;
    const Point &a = rings_.points[first], &b = rings_.points[v], &c = rings_.points[last];
    const noding::Along along(a, c);
    const auto is_in_span = [](const NearVertex& n, std::uint32_t span) { return n.span < span; };
    const std::uint32_t span = spans_.members[member_of(v)].span;
    const auto begin = std::lower_bound(near_.begin(), near_.end(), span, is_in_span);
    const auto end = std::lower_bound(begin, near_.end(), span + 1, is_in_span);
    auto it = std::partition_point(begin, end, [&](const NearVertex& n) { return !along(a, rings_.points[n.vertex]); });
    for (; it != end; ++it) {
      const Point& p = rings_.points[it->vertex];
      if (!along(p, c)) break;
      if (gone_[it->vertex] || !box_of(a, b, c).contains(p)) continue;
      const bool on_first = along(p, b);
      if (is_between(a, c, on_first ? a : b, on_first ? b : c, p)) return false;
    }
    return true;
  }

  static Box box_of(const Point& a, const Point& b, const Point& c) { return Box::of(a, c).joined(b); }

  /// Whether an edge joins the places of two vertices.
  bool has_edge(std::uint32_t v, std::uint32_t w) const {
    if (!(rings_.flags[v] & touch_vertex)) return joins(v, rings_.points[w]);
    if (!(rings_.flags[w] & touch_vertex)) return joins(w, rings_.points[v]);
    const auto [begin, end] = std::equal_range(touches_.begin(), touches_.end(), v,
                                               [&](std::uint32_t p, std::uint32_t q) { return less(p, q); });
    return std::any_of(begin, end, [&](std::uint32_t u) { return joins(u, rings_.points[w]); });
  }
  bool joins(std::uint32_t v, const Point& p) const {
    return rings_.points[before_[v]] == p || rings_.points[after_[v]] == p;
  }

  void take_out(std::uint32_t v) {
    gone_[v] = true;
    const std::uint32_t before = before_[v], after = after_[v];
    after_[before] = after;
    before_[after] = before;
    for (const std::uint32_t neighbour : {before, after}) {
      keep_common_edges(neighbour, v);
      waits_[neighbour] = false;
      push(neighbour);
    }
    // The edges that this vertex blocked.
    auto it = std::lower_bound(by_vertex_.begin(), by_vertex_.end(), v,
                               [&](std::uint32_t i, std::uint32_t vertex) { return near_[i].vertex < vertex; });
    for (; it != by_vertex_.end() && near_[*it].vertex == v; ++it) {
      const TraceSpan& span = spans_.spans[near_[*it].span];
      const std::uint32_t u = staying_before(spans_.vertex(span, near_[*it].piece));
      push(u);
      push(after_[u]);
    }
  }

  /// The edge that replaces the two at `gone` is a piece of the input edges of which both were pieces.
  void keep_common_edges(std::uint32_t v, std::uint32_t gone) {
    for (std::size_t m = member_of(v); is_of(m, v); ++m) {
      bool common = false;
      for (std::size_t g = member_of(gone); is_of(g, gone); ++g)
        common |= counts_[g] && spans_.members[g].edge == spans_.members[m].edge;
      counts_[m] = counts_[m] && common;
    }
  }

  /// The vertex itself, or the last remaining one before it in its ring. Shortens the path for the next call.
  std::uint32_t staying_before(std::uint32_t v) {
    std::uint32_t found = v;
    while (gone_[found]) found = before_[found];
    while (gone_[v]) v = std::exchange(before_[v], found);
    return found;
  }

  const TraceSpans& spans_;
  const Rings& rings_;
  Array<bool>& gone_;
  Array<std::uint32_t> before_, after_;  ///< by vertex; for a removed one: a vertex before it
  Array<bool> waits_;                    ///< by vertex: its newest candidate is in the queue
  Array<bool> counts_;                   ///< by member: both edges at the vertex are still pieces of the input edge
  Array<std::uint32_t> touches_;
  Array<NearVertex> near_;          ///< by span, and along it
  Array<std::uint32_t> by_vertex_;  ///< indices of elements of near_ that may be removed, by vertex
  std::priority_queue<Candidate, Array<Candidate>, Later> queue_;
};

}  // namespace

void retry_traces(const TraceSpans& spans, const Array<bool>& refused, const Array<NearVertex>& near,
                  Array<bool>& gone) {
  if (std::find(refused.begin(), refused.end(), true) != refused.end()) Retry(spans, refused, near, gone).run();
}

}  // namespace oblast::internal
