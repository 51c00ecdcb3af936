// Edges that cancel leave no vertices in the result (promise G3a).
//
// All spans of trace vertices that may be removed are removed at once (trace_spans.h says which). From the other spans,
// vertices are removed one by one until no more can be removed (retry_traces.h). So the outcome depends on the result
// alone, promise G2 holds, and no vertex remains that could be removed.
#include "result/remove_traces.h"

#include <algorithm>

#include "base/parallel.h"
#include "exact/orientation.h"
#include "result/retry_traces.h"
#include "result/trace_spans.h"

namespace oblast::internal {
namespace {

/// Two points, the smaller one first.
struct Ends {
  Point low, high;

  Ends(const Point& p, const Point& q) : low(p), high(q) {
    if (lexicographically_less(q, p)) std::swap(low, high);
  }
  friend bool operator==(const Ends&, const Ends&) = default;
  friend bool operator<(const Ends& p, const Ends& q) {
    return p.low != q.low ? lexicographically_less(p.low, q.low) : lexicographically_less(p.high, q.high);
  }
};

/// Rule 1 of trace_spans.h.
void refuse_where_vertices_lie_between(const TraceSpans& spans, const Array<NearVertex>& near, Array<bool>& refused) {
  Steps steps(near.size());
  for (const NearVertex& n : near) {
    steps();
    if (refused[n.span]) continue;
    const TraceSpan& span = spans.spans[n.span];
    refused[n.span] = is_between(spans.point(span, 0), spans.point(span, span.count + 1), spans.point(span, n.piece),
                                 spans.point(span, n.piece + 1), spans.rings.points[n.vertex]);
  }
}

/// Rule 2.
void refuse_where_ends_are_shared(const TraceSpans& spans, Array<bool>& refused) {
  struct Chord {
    Ends ends;
    std::uint32_t span;
  };
  Array<Chord> chords;
  for (std::uint32_t s = 0; s < spans.spans.size(); ++s) {
    const TraceSpan& span = spans.spans[s];
    chords.push_back({{spans.point(span, 0), spans.point(span, span.count + 1)}, s});
  }
  parallel_sort(chords.begin(), chords.end(), [](const Chord& p, const Chord& q) { return p.ends < q.ends; });
  for (std::size_t i = 1; i < chords.size(); ++i)
    if (chords[i].ends == chords[i - 1].ends) refused[chords[i].span] = refused[chords[i - 1].span] = true;

  // An edge between both ends of a chord begins at an end of the chord.
  const Rings& rings = spans.rings;
  Steps steps(rings.points.size());
  for (std::size_t r = 0; r < rings.size(); ++r) {
    for (std::uint32_t v = rings.begin(r); v < rings.ends[r]; ++v) {
      steps();
      if (!rings.has_edge_after(r, v)) continue;
      const Ends edge(rings.points[v], rings.points[rings.after(r, v)]);
      const auto less = [](const Chord& chord, const Ends& ends) { return chord.ends < ends; };
      for (auto it = std::lower_bound(chords.begin(), chords.end(), edge, less); it != chords.end() && it->ends == edge;
           ++it)
        refused[it->span] = true;
    }
  }
}

Rings drop_collinear(const Rings& rings) {
  // A vertex that is collinear with both neighbours is collinear with the next vertices that remain on either side. The
  // ends of an open path are touches, so they remain.
  return without_if(rings, [&](std::size_t r, std::uint32_t v) {
    const Point &before = rings.points[rings.before(r, v)], &after = rings.points[rings.after(r, v)];
    return !(rings.flags[v] & touch_vertex) && exact::orientation(before, rings.points[v], after) == 0;
  });
}

Rings without_traces(Rings rings) {
  const TraceSpans spans(rings);
  if (spans.spans.empty()) return rings;
  const Array<NearVertex> near = find_near_vertices(spans);
  Array<bool> refused(spans.spans.size(), false);
  for (std::size_t s = 0; s < refused.size(); ++s) refused[s] = !spans.spans[s].is_whole || !spans.spans[s].is_monotone;
  refuse_where_vertices_lie_between(spans, near, refused);
  refuse_where_ends_are_shared(spans, refused);

  Array<bool> gone(rings.points.size(), false);
  for (std::size_t s = 0; s < refused.size(); ++s)
    for (std::uint32_t i = 1; !refused[s] && i <= spans.spans[s].count; ++i)
      gone[spans.vertex(spans.spans[s], i)] = true;
  retry_traces(spans, refused, near, gone);
  return without_if(rings, [&](std::size_t, std::uint32_t v) { return gone[v]; });
}

}  // namespace

Rings remove_traces(Rings rings, CollinearVertices collinear) {
  rings = without_traces(std::move(rings));
  return collinear == CollinearVertices::drop ? drop_collinear(rings) : std::move(rings);
}

}  // namespace oblast::internal
