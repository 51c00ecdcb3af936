// The constrained Delaunay triangulation of regions: every side of a polygon is a side of triangles.
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

/// Which triangles a triangulation contains.
enum class TriangleExtent {
  interior,     ///< the triangles inside the polygons
  convex_hull,  ///< all triangles up to the convex hull of the vertices
};

/// What the input is.
enum class TriangleInput {
  any,     ///< any contours; they are united first, with the options of the call
  result,  ///< the result of an overlay (promise G2); it is triangulated as it is
};

/// The options of the union that comes first, and two more. With TriangleInput::result there is no union, and only the
/// CallOptions have an effect.
struct TriangulateOptions : Options {
  TriangleExtent extent = TriangleExtent::interior;
  TriangleInput input = TriangleInput::any;
};

struct Triangulation {
  static constexpr std::uint32_t none = 0xffffffff;

  RegionSet regions;          ///< the regions that were triangulated: the union, or the input as it was
  std::vector<Point> points;  ///< the vertices: each different point of `regions` once, in order of first appearance
  std::vector<std::array<std::uint32_t, 3>> triangles;   ///< indices into points, counter-clockwise
  std::vector<std::array<std::uint32_t, 3>> neighbours;  ///< for each side: the triangle beyond it, or `none`
  std::vector<std::array<bool, 3>> is_side;              ///< for each side: whether it is a side of a polygon
  std::vector<std::uint32_t> polygon;  ///< for each triangle: the polygon of `regions` that contains it, or `none`
};

/// Triangulates the union of the regions. The triangulation is Delaunay as far as the sides of polygons allow: the
/// circumcircle of a triangle contains no vertex that is visible from inside the triangle. Exact predicates decide
/// this, and coordinates do not change. The same input always gives the same triangles in the same order, which follows
/// a space-filling curve.
/// Cost: the union, then O(n log n) for the spatial sort and O(n) on average for the rest; about 200 bytes per vertex.
/// Throws Error: as `unite`; too_large for 2^29 vertices or more; precondition, with TriangleInput::result, if sides
/// cross or pass through vertices.
OBLAST_API Triangulation triangulate(const RegionView& regions, const TriangulateOptions& options = {});

}  // namespace oblast
