// The contours of the result as points, before they are put in canonical order.
#pragma once

#include <algorithm>
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
  std::uint32_t before(std::size_t ring, std::uint32_t vertex) const {
    return vertex == begin(ring) ? ends[ring] - 1 : vertex - 1;
  }
  std::uint32_t after(std::size_t ring, std::uint32_t vertex) const {
    return vertex + 1 == ends[ring] ? begin(ring) : vertex + 1;
  }
  std::size_t ring_of(std::uint32_t vertex) const {
    return static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), vertex) - ends.begin());
  }
};

/// The rings without the vertices for which drop(ring, vertex) says so. Cost: linear.
template <class Drop>
Rings without_if(const Rings& rings, const Drop& drop) {
  Rings result;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    for (std::uint32_t v = rings.begin(r); v < rings.ends[r]; ++v) {
      if (drop(r, v)) continue;
      result.points.push_back(rings.points[v]);
      result.flags.push_back(rings.flags[v]);
    }
    result.ends.push_back(static_cast<std::uint32_t>(result.points.size()));
  }
  return result;
}

/// By node: RingVertex bits of the vertex there. Cost: linear in the chains.
Array<std::uint8_t> classify_nodes(const ChainGraph& graph, const Selection& selection);

/// The points of every contour, with what the graph knows of them. Cost: linear.
Rings contours_to_rings(const ChainGraph& graph, const Selection& selection, const LinkedContours& linked);

/// Takes out every trace vertex that may go (promise G3a, trace_spans.h), and, under CollinearVertices::drop, exactly
/// collinear ones. Cost: O((n + k) log n), where k vertices lie near edges that had traces; linear if there are none.
Rings remove_traces(Rings rings, CollinearVertices collinear);

}  // namespace oblast
