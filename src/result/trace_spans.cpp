#include "result/trace_spans.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "base/parallel.h"
#include "exact/orientation.h"
#include "noding/along.h"
#include "noding/pair_finder.h"
#include "plane/smallest_vertex.h"

namespace oblast::internal {
namespace {

using noding::Along;
using noding::Run;

constexpr noding::Group span_group = 1, vertex_group = 2;

/// The strip that contains the vertices of a span.
struct Strip {
  Box box;
  double least, most;  ///< bounds of the doubled areas between the chord and its vertices, including rounding errors
  double reach;        ///< at least the distance of any of its vertices from the chord
};

/// The doubled area of the triangle (a, b, p). Positive if p is left of the chord.
double area_over(const Point& a, const Point& b, const Point& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

Strip strip_of(const TraceSpans& spans, const TraceSpan& span) {
  const Point &a = spans.point(span, 0), &b = spans.point(span, span.count + 1);
  const Box chord = Box::of(a, b);
  Strip strip{chord, 0, 0, 0};
  for (std::uint32_t i = 1; i <= span.count; ++i) {
    const Point& t = spans.point(span, i);
    const double area = area_over(a, b, t);
    strip.least = std::min(strip.least, area);
    strip.most = std::max(strip.most, area);
    strip.box = strip.box.joined(t);
  }
  // In the box of the strip, the error of an area is at most four epsilons of this product. In the domain of
  // coordinates nothing underflows or overflows.
  const double width = strip.box.x1 - strip.box.x0, height = strip.box.y1 - strip.box.y0;
  const double error = 16 * std::numeric_limits<double>::epsilon() * width * height;
  strip.least -= error;
  strip.most += error;
  // The pieces are in the hull of the vertices of the span. The largest distance from the chord is at one of these
  // vertices. It is at most the distance from the line plus the distance from the box of the chord.
  const double beyond =
      (chord.x0 - strip.box.x0) + (strip.box.x1 - chord.x1) + (chord.y0 - strip.box.y0) + (strip.box.y1 - chord.y1);
  const double length = std::max(chord.x1 - chord.x0, chord.y1 - chord.y0);
  strip.reach = (std::max(-strip.least, strip.most) / length + beyond) * (1 + 0x1p-20);
  return strip;
}

class NearVertexFinder {
 public:
  explicit NearVertexFinder(const TraceSpans& spans) : spans_(spans) {}

  Array<NearVertex> run() {
    LargeArray<Run> runs = chords();
    if (runs.empty()) return {};
    add_vertices(runs);
    const noding::PairVisitor visit = [&](std::span<const noding::RunPair> pairs) {
      poll();
      look_at(pairs);
    };
    noding::find_pairs(ends_, std::move(runs), visit, noding::PairGoal::meetings);
    parallel_sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    return std::move(found_);
  }

 private:
  /// Adds an edge to the search. Every chord is an edge, and every vertex is an edge from itself to itself.
  void add(const Point& p, const Point& q, double reach, noding::Group group, LargeArray<Run>& runs) {
    const auto edge = static_cast<std::uint32_t>(ends_.size());
    ends_.push_back(p);
    ends_.push_back(q);
    Run run{Box::of(p, q), edge, edge + 1, group, Run::marks_of(false, reach)};
    run.box = run.box.widened(run.margin());
    runs.push_back(run);
  }

  LargeArray<Run> chords() {
    LargeArray<Run> runs;
    Steps steps(spans_.spans.size());
    for (std::uint32_t s = 0; s < spans_.spans.size(); ++s) {
      steps();
      const TraceSpan& span = spans_.spans[s];
      if (!span.is_monotone) continue;
      strips_.push_back(strip_of(spans_, span));
      span_of_chord_.push_back(s);
      add(spans_.point(span, 0), spans_.point(span, span.count + 1), strips_.back().reach, span_group, runs);
    }
    return runs;
  }

  /// Adds one vertex for each point. At a fan that touches itself, many vertices have the same point.
  void add_vertices(LargeArray<Run>& runs) {
    const Rings& rings = spans_.rings;
    Array<std::uint32_t> touches;
    for (std::uint32_t v = 0; v < rings.points.size(); ++v)
      (rings.flags[v] & touch_vertex ? touches : vertices_).push_back(v);
    parallel_sort(touches.begin(), touches.end(), [&](std::uint32_t v, std::uint32_t w) {
      const Point &p = rings.points[v], &q = rings.points[w];
      return p != q ? lexicographically_less(p, q) : v < w;
    });
    for (std::size_t i = 0; i < touches.size(); ++i)
      if (i == 0 || rings.points[touches[i]] != rings.points[touches[i - 1]]) vertices_.push_back(touches[i]);
    ends_.reserve(ends_.size() + 2 * vertices_.size());
    runs.reserve(runs.size() + vertices_.size());
    for (const std::uint32_t v : vertices_) add(rings.points[v], rings.points[v], 0, vertex_group, runs);
  }

  void look_at(std::span<const noding::RunPair> pairs) {
    Array<NearVertex> found;
    const auto chords = static_cast<std::uint32_t>(strips_.size());
    for (const noding::RunPair& pair : pairs) {
      const std::uint32_t chord = std::min(pair.first_p, pair.first_q) / 2;
      look_at(chord, vertices_[std::max(pair.first_p, pair.first_q) / 2 - chords], found);
    }
    if (found.empty()) return;
    const std::lock_guard lock(mutex_);
    found_.insert(found_.end(), found.begin(), found.end());
  }

  void look_at(std::uint32_t chord, std::uint32_t vertex, Array<NearVertex>& found) const {
    const Strip& strip = strips_[chord];
    const Point& p = spans_.rings.points[vertex];
    if (!strip.box.contains(p)) return;
    const std::uint32_t number = span_of_chord_[chord];
    const TraceSpan& span = spans_.spans[number];
    const Point &a = spans_.point(span, 0), &b = spans_.point(span, span.count + 1);
    const double area = area_over(a, b, p);
    if (area < strip.least || area > strip.most || p == a || p == b) return;
    const std::uint32_t piece = piece_beside(span, p);
    // At the points of its vertices lie only its own vertices: they are nodes with two edges.
    if (p == spans_.point(span, piece) || p == spans_.point(span, piece + 1)) return;
    found.push_back({number, piece, vertex});
  }

  std::uint32_t piece_beside(const TraceSpan& span, const Point& p) const {
    const Along along(spans_.point(span, 0), spans_.point(span, span.count + 1));
    std::uint32_t low = 0, high = span.count + 1;  // the piece is one of [low, high)
    while (high - low > 1) {
      const std::uint32_t middle = low + (high - low) / 2;
      (along(p, spans_.point(span, middle)) ? high : low) = middle;
    }
    return low;
  }

  const TraceSpans& spans_;
  LargeArray<Point> ends_;              ///< two for each edge of the search
  Array<Strip> strips_;                 ///< by chord
  Array<std::uint32_t> span_of_chord_;  ///< the number of a span
  Array<std::uint32_t> vertices_;       ///< the vertices of the search, as indices in the points of the rings
  std::mutex mutex_;
  Array<NearVertex> found_;
};

bool is_monotone(const TraceSpans& spans, const TraceSpan& span) {
  const Along along(spans.point(span, 0), spans.point(span, span.count + 1));
  for (std::uint32_t i = 0; i <= span.count; ++i)
    if (!along(spans.point(span, i), spans.point(span, i + 1))) return false;
  return true;
}

}  // namespace

TraceSpans::TraceSpans(const Rings& all) : rings(all) {
  if (rings.trace_edges.empty()) return;
  const auto is_trace = [&](std::uint32_t v) { return (rings.flags[v] & trace_vertex) != 0; };
  Steps steps(rings.points.size());
  for (std::uint32_t r = 0; r < rings.size(); ++r) {
    const std::uint32_t begin = rings.begin(r), end = rings.ends[r];
    std::uint32_t start = begin;
    while (start < end && is_trace(start)) ++start;
    // If a ring has only trace vertices (it is a few units in the last place wide), its smallest vertex remains.
    if (start == end) start = begin + smallest_vertex(std::span(rings.points).subspan(begin, end - begin)).vertex;
    for (std::uint32_t v = start;;) {
      std::uint32_t count = 0, w = rings.after(r, v);
      for (; w != start && is_trace(w); w = rings.after(r, w)) ++count;
      steps();
      if (count > 0) add_run(r, v, count);
      if (w == start) break;
      v = w;
    }
  }
  for (TraceSpan& span : spans) span.is_monotone = is_monotone(*this, span);
  parallel_sort(members.begin(), members.end(), [](const SpanMember& p, const SpanMember& q) {
    return p.vertex != q.vertex ? p.vertex < q.vertex : p.edge < q.edge;
  });
}

/// Adds the spans of the `count` trace vertices after the vertex `first`.
void TraceSpans::add_run(std::uint32_t ring, std::uint32_t first, std::uint32_t count) {
  const TraceSpan run{ring, first, count, true, true};
  Array<TraceEdge> open;  // edges of the vertex visited last; `at` is the span of each
  for (std::uint32_t i = 1; i <= count; ++i) {
    const std::uint32_t v = vertex(run, i), before = vertex(run, i - 1);
    Array<TraceEdge> still_open;
    for (const TraceEdge& edge : trace_edges_at(rings.trace_edges, v)) {
      const auto it = std::find_if(open.begin(), open.end(), [&](const TraceEdge& o) { return o.edge == edge.edge; });
      if (it == open.end()) {
        still_open.push_back({static_cast<std::uint32_t>(spans.size()), edge.edge});
        spans.push_back({ring, before, 0, false, false});
      } else {
        still_open.push_back(*it);
      }
      ++spans[still_open.back().at].count;
      members.push_back({v, edge.edge, still_open.back().at});
    }
    open = std::move(still_open);
  }
  // Now `open` has the spans that reach the end of the run.
  bool has_whole = false;
  for (const TraceEdge& o : open) {
    TraceSpan& span = spans[o.at];
    span.is_whole = !has_whole && span.count == count;
    has_whole |= span.is_whole;
  }
}

Array<NearVertex> find_near_vertices(const TraceSpans& spans) { return NearVertexFinder(spans).run(); }

// A line through p across the chain crosses the chord and one piece. p is between them if it is on different sides of
// them.
bool is_between(const Point& a, const Point& b, const Point& u, const Point& w, const Point& p) {
  const int side = exact::orientation(a, b, p);
  return side == 0 || exact::orientation(u, w, p) != side;
}

}  // namespace oblast::internal
