// The constrained Delaunay triangulation of regions: every side of the polygons is a side of triangles.
//
//              v[2]              triangle t: vertices v[0], v[1], v[2] counter-clockwise; its
//             /    \             neighbour i lies beyond side i, from v[i] to v[(i + 1) % 3]
//        n[2] /  t   \ n[1]
//           /        \           .
//        v[0] -n[0]- v[1]
#pragma once

#include <oblast/error.h>
#include <oblast/export.h>
#include <oblast/options.h>
#include <oblast/region_set.h>

#include <array>
#include <cstdint>
#include <vector>

namespace oblast {

/// Which triangles a triangulation holds.
enum class TriangleExtent {
  interior,     ///< those inside the polygons
  convex_hull,  ///< all up to the convex hull of the vertices
};

/// What is known of the regions to be triangulated.
enum class TriangleInput {
  any,     ///< any contours: they are united first, as the other options say
  result,  ///< the result of an overlay (promise G2): taken as it is
};

/// Those of the union that comes first, of which TriangleInput::result has no use but as CallOptions, and two more.
struct TriangulateOptions : Options {
  TriangleExtent extent = TriangleExtent::interior;
  TriangleInput input = TriangleInput::any;
};

struct Triangulation {
  static constexpr std::uint32_t none = 0xffffffff;

  RegionSet regions;          ///< what was triangulated: the united regions
  std::vector<Point> points;  ///< vertices: the points of `regions`, each place once, in order of first appearance
  std::vector<std::array<std::uint32_t, 3>> triangles;   ///< indices into points, counter-clockwise
  std::vector<std::array<std::uint32_t, 3>> neighbours;  ///< triangle beyond each side, or none
  std::vector<std::array<bool, 3>> is_side;              ///< the side is a side of a polygon
  std::vector<std::uint32_t> polygon;                    ///< polygon of `regions` the triangle is in, or none
};

/// Delaunay as far as the sides allow: no vertex visible from inside a triangle lies in its circle. Decided
/// exactly; coordinates are not changed. Triangles are ordered by position along a space-filling curve,
/// the same for the same input.
/// Cost: the union, then O(n) on average, O(n log n) with the spatial sort; about 200 bytes a vertex.
/// Throws Error: as `unite`; too_large from 2^29 vertices; precondition for TriangleInput::result when sides
/// cross or pass through vertices.
OBLAST_API Triangulation triangulate(const RegionView& regions, const TriangulateOptions& options = {});

}  // namespace oblast
