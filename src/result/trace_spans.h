// Spans of trace vertices, and what lies near them.
//
//   a --- t1 --- t2 --- b        a span: trace vertices t that follow one another, and the vertices on either side; the
//                                edges between them are pieces of one input edge
//   a ----------------- b        its chord, the edge that would take the place of the pieces
//
// The chord may replace the pieces if and only if
//   1. no other vertex of the result lies between them or on the chord, and
//   2. no other edge, and no other chord, has the ends a and b.
// Why this is enough: the pieces cross no edge of the result. An edge that crosses the chord from outside enters the
// area between; it cannot leave through the pieces, nor through the chord again, so it ends inside: a vertex. The same
// count of crossings around the area shows that chords of two such spans do not cross each other. Why it is needed: a
// vertex between them would be on the other side of the boundary afterwards. So whether a span may go depends on no
// other span but through rule 2, and all that may go can go at once.
#pragma once

#include <cstdint>

#include "base/call_memory.h"
#include "result/rings.h"

namespace oblast::internal {

struct TraceSpan {
  std::uint32_t ring;
  std::uint32_t first;  ///< a, index in the rings' points
  std::uint32_t count;  ///< of its trace vertices, at least 1
  bool is_whole;        ///< neither a nor b is a trace vertex; of equal spans this is true of one
  bool is_monotone;     ///< its vertices follow one another along the chord
};

/// A trace vertex, an input edge of which the edges there are pieces, and the span of that edge. Where trace vertices
/// of different input edges follow one another, spans overlap, and a vertex may be in several.
struct SpanMember {
  std::uint32_t vertex, edge, span;
};

/// A vertex that lies in the strip around a span's vertices, and in their box.
struct NearVertex {
  std::uint32_t span;
  std::uint32_t piece;   ///< of the span, counted from 0: the one beside the vertex
  std::uint32_t vertex;  ///< index in the rings' points

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

/// All of every span that is monotone, sorted. Where none is in a span's list, the span may go by rule 1; where some
/// are, is_between() decides. Cost: O((n + k) log n) expected, for k such vertices.
Array<NearVertex> find_near_vertices(const TraceSpans& spans);

/// Whether p lies between the chord (a, b) and a chain of pieces from a to b, or on the chord. (u, w) is the piece
/// beside p. REQUIRES: p is in the box of the chain, and no vertex of it.
bool is_between(const Point& a, const Point& b, const Point& u, const Point& w, const Point& p);

}  // namespace oblast::internal
