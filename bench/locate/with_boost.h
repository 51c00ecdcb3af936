// Polygons in Boost's types and a packed tree of their boxes; GEOS' polygons are found by the same tree.
#pragma once

#include <oblast/region_set.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cstdint>
#include <utility>
#include <vector>

namespace oblast::bench {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<BoostPoint, false>;  // outer rings counter-clockwise
using PolygonTree = bg::index::rtree<std::pair<bg::model::box<BoostPoint>, std::uint32_t>, bg::index::rstar<16>>;

inline std::vector<BoostPolygon> boost_polygons(const RegionView& regions) {
  std::vector<BoostPolygon> polygons(regions.polygon_count());
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    const std::uint32_t first = regions.polygon_begin(p), end = regions.polygon_end(p);
    polygons[p].inners().resize(end - first - 1);
    for (std::uint32_t c = first; c < end; ++c) {
      auto& ring = c == first ? polygons[p].outer() : polygons[p].inners()[c - first - 1];
      for (const Point& v : regions.contour(c)) ring.emplace_back(v.x, v.y);
      ring.push_back(ring.front());
    }
  }
  return polygons;
}

inline PolygonTree tree_of(const std::vector<BoostPolygon>& polygons) {
  std::vector<PolygonTree::value_type> boxes;
  for (const BoostPolygon& polygon : polygons)
    boxes.emplace_back(bg::return_envelope<bg::model::box<BoostPoint>>(polygon.outer()),
                       static_cast<std::uint32_t>(boxes.size()));
  return PolygonTree(boxes);
}

/// Whether a polygon whose box holds the point is found to hold it.
template <class Holds>
bool is_in_any(const PolygonTree& tree, const BoostPoint& p, const Holds& holds) {
  for (auto found = tree.qbegin(bg::index::intersects(p)); found != tree.qend(); ++found)
    if (holds(found->second)) return true;
  return false;
}

}  // namespace oblast::bench
