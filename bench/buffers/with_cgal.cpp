// CGAL: approximated_offset_2 of each polygon, with the tolerance of the chords as its own, and the union of the
// results. It takes single polygons of regions and positive distances; everything else is not supported. Its arcs are
// replaced by their chords only when the result is written, which is not timed.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/General_polygon_set_2.h>
#include <CGAL/Gps_circle_segment_traits_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/approximated_offset_2.h>

#include <cmath>
#include <iterator>

#include "buffers/shape_file.h"

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Ring = CGAL::Polygon_2<Kernel>;
using Polygon = CGAL::Polygon_with_holes_2<Kernel>;
using Traits = CGAL::Gps_circle_segment_traits_2<Kernel>;
using Set = CGAL::General_polygon_set_2<Traits>;

std::vector<Polygon> polygons_of(const buffers::Shapes& shapes) {
  std::vector<Polygon> all;
  std::uint64_t point = 0, contour = 0;
  for (const std::uint64_t end : shapes.polygon_ends) {
    std::vector<Ring> rings;
    for (; contour < end; ++contour) {
      Ring& ring = rings.emplace_back();
      for (; point < shapes.contour_ends[contour]; ++point)
        ring.push_back({shapes.region_points[point].x, shapes.region_points[point].y});
      const bool outer = rings.size() == 1;
      if ((ring.orientation() == CGAL::COUNTERCLOCKWISE) != outer) ring.reverse_orientation();
    }
    all.emplace_back(rings[0], rings.begin() + 1, rings.end());
  }
  return all;
}

template <class General>
std::vector<buffers::Xy> ring_of(const General& polygon) {
  std::vector<buffers::Xy> ring;
  for (auto curve = polygon.curves_begin(); curve != polygon.curves_end(); ++curve)
    ring.push_back({CGAL::to_double(curve->source().x()), CGAL::to_double(curve->source().y())});
  return ring;
}

}  // namespace

int main(int argc, char** argv) {
  const auto make = [](const buffers::Arguments& arguments) {
    if (arguments.shapes.polygon_ends.empty() || arguments.distance < 0)
      throw std::runtime_error("not supported: CGAL offsets polygons outwards");
    return [polygons = polygons_of(arguments.shapes), &arguments] {
      const double off = std::abs(arguments.distance) * (1 - std::cos(3.14159265358979323846 / arguments.segments));
      Set zone;
      for (const Polygon& polygon : polygons)
        zone.join(CGAL::approximated_offset_2(polygon, Kernel::FT(arguments.distance), off));
      return zone;
    };
  };
  const auto write = [](const Set& zone) {
    std::vector<Set::Polygon_with_holes_2> all;
    zone.polygons_with_holes(std::back_inserter(all));
    buffers::Shapes shapes;
    for (const auto& polygon : all) {
      shapes.add_ring(ring_of(polygon.outer_boundary()));
      for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) shapes.add_ring(ring_of(*hole));
      shapes.end_polygon();
    }
    return shapes;
  };
  return buffers::drive(argc, argv, make, write);
}
