// Spans of trace vertices, and what lies near them.
//
//   a --- t1 --- t2 --- b        a span: consecutive trace vertices t, and the vertices on either side; the edges
//   between
//                                them are pieces of one input edge
//   a ----------------- b        its chord, the edge that may replace the pieces
//
// The chord may replace the pieces if and only if
//   1. no other vertex of the result lies between them or on the chord, and
//   2. no other edge, and no other chord, has the ends a and b.
// Why this is sufficient: the pieces cross no edge of the result. An edge that crosses the chord from outside enters
// the area between chord and pieces. It cannot leave through the pieces, nor through the chord again. So it ends
// inside, at a vertex. Counting crossings around the area in the same way shows that the chords of two such spans do
// not cross. Why this is necessary: afterwards a vertex between them would be on the other side of the boundary. So
// spans depend on each other only through rule 2, and all spans that may be removed can be removed at once.
#pragma once

#include <cstdint>

#include "base/call_memory.h"
#include "result/rings.h"

namespace oblast::internal {

struct TraceSpan {
  std::uint32_t ring;
  std::uint32_t first;  ///< a, as an index in the points of the rings
  std::uint32_t count;  ///< number of its trace vertices, at least 1
  bool is_whole;        ///< neither a nor b is a trace vertex; of several equal spans, true for one
  bool is_monotone;     ///< its vertices are in order along the chord
};

/// A trace vertex, an input edge of which the edges there are pieces, and the span of that edge. If consecutive trace
/// vertices belong to different input edges, spans overlap, and a vertex may be in several.
struct SpanMember {
  std::uint32_t vertex, edge, span;
};

/// A vertex in the strip around the vertices of a span, and in their box.
struct NearVertex {
  std::uint32_t span;
  std::uint32_t piece;   ///< the piece of the span beside the vertex, counted from 0
  std::uint32_t vertex;  ///< index in the points of the rings

  friend auto operator<=>(const NearVertex&, const NearVertex&) = default;
};

struct TraceSpans {
  explicit TraceSpans(const Rings& rings);

  const Rings& rings;
  Array<TraceSpan> spans;
  Array<SpanMember> members;  ///< by vertex, and by edge

  /// Vertex number i of a span: 0 is a, count + 1 is b.
  std::uint32_t vertex(const TraceSpan& span, std::uint32_t i) const {
    const std::uint32_t v = span.first + i, end = rings.ends[span.ring];
    return v < end ? v : v - (end - rings.begin(span.ring));
  }
  const Point& point(const TraceSpan& span, std::uint32_t i) const { return rings.points[vertex(span, i)]; }

 private:
  void add_run(std::uint32_t ring, std::uint32_t first, std::uint32_t count);
};

/// The near vertices of every monotone span, sorted. A span without near vertices may be removed by rule 1. For the
/// others is_between() decides. Cost: O((n + k) log n) expected for k such vertices.
Array<NearVertex> find_near_vertices(const TraceSpans& spans);

/// Whether p lies between the chord (a, b) and a chain of pieces from a to b, or on the chord. (u, w) is the piece
/// beside p. REQUIRES: p is in the box of the chain, and is not a vertex of it.
bool is_between(const Point& a, const Point& b, const Point& u, const Point& w, const Point& p);

}  // namespace oblast::internal
