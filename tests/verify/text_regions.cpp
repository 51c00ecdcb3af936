// Region sets written in a line.
#include "verify/text_regions.h"

#include <sstream>

namespace oblast::verify {

RegionSet regions_of(const std::string& text) {
  RegionSet regions;
  std::istringstream polygons(text);
  for (std::string polygon; std::getline(polygons, polygon, '|');) {
    std::istringstream contours(polygon);
    for (std::string contour; std::getline(contours, contour, ';');) {
      std::istringstream vertices(contour);
      for (std::string vertex; std::getline(vertices, vertex, ',');) {
        std::istringstream coordinates(vertex);
        Point p;
        coordinates >> p.x >> p.y;
        regions.points.push_back(p);
      }
      regions.contour_ends.push_back(static_cast<std::uint32_t>(regions.points.size()));
    }
    regions.polygon_ends.push_back(static_cast<std::uint32_t>(regions.contour_ends.size()));
  }
  return regions;
}

}  // namespace oblast::verify
