// The contours of the result as points, before they are put in canonical order.
#pragma once

#include <cstdint>
#include <span>

#include "memory/large_pages.h"
#include "overlay/link.h"

namespace oblast {

/// What is known of a vertex of the result; a set of bits.
enum RingVertex : std::uint8_t {
  trace_vertex = 1,  ///< added by noding between two pieces of one input edge: to be taken out if possible
  touch_vertex = 2,  ///< more than two edges of the result meet here
};

struct Rings {
  LargeArray<Point> points;
  Array<std::uint8_t> flags;  ///< by vertex, RingVertex
  Array<std::uint32_t> ends;  ///< by ring: past its last vertex; the first is not repeated

  std::uint32_t begin(std::size_t ring) const { return ring == 0 ? 0 : ends[ring - 1]; }
  std::size_t size() const { return ends.size(); }
};

/// By node: RingVertex bits of the vertex there. Cost: linear in the chains.
Array<std::uint8_t> classify_nodes(const ChainGraph& graph, const Selection& selection);

/// The points of every contour, with what the graph knows of them. Cost: linear.
Rings contours_to_rings(const ChainGraph& graph, const Selection& selection, const LinkedContours& linked);

/// Takes trace vertices out (promise G3a) wherever the straightened edge meets nothing of the result,
/// and, under CollinearVertices::drop, exactly collinear ones. Cost: as one rounding round, and
/// linear where there is nothing to take out.
Rings remove_traces(Rings rings, CollinearVertices collinear);

}  // namespace oblast
