#include "buffer/wkt_shapes.h"

#include <stdexcept>

#include "text/wkt_scanner.h"

namespace oblast::testing {
namespace {

class ShapesOfWkt {
 public:
  OwnedShapes read(std::string_view text) {
    text::WktScanner<ShapesOfWkt> scanner(text, *this);
    scanner.geometry();
    return std::move(shapes_);
  }

  bool enter(const text::WktType& type, std::size_t, std::size_t byte) {
    for (const char* known :
         {"POINT", "LINESTRING", "POLYGON", "MULTIPOINT", "MULTILINESTRING", "MULTIPOLYGON", "GEOMETRYCOLLECTION"})
      if (type.name == known) return true;
    fail("unknown geometry: " + type.name, byte);
  }
  void begin_polygon() { contours_before_ = shapes_.regions.contour_ends.size(); }
  void vertex(const text::WktVertex& vertex) { vertices_.push_back(vertex.at); }
  void end_ring() {
    if (!vertices_.empty()) move_to(shapes_.regions.points, shapes_.regions.contour_ends);
  }
  void end_polygon() {
    RegionSet& regions = shapes_.regions;
    if (regions.contour_ends.size() > contours_before_)
      regions.polygon_ends.push_back(static_cast<std::uint32_t>(regions.contour_ends.size()));
  }
  void end_line() { move_to(shapes_.line_points, shapes_.line_ends); }
  void end_point() {
    shapes_.points.push_back(vertices_.back());
    vertices_.clear();
  }
  void poll() {}
  [[noreturn]] void fail(const std::string& what, std::size_t byte) const {
    throw std::runtime_error(what + " at byte " + std::to_string(byte));
  }
  [[noreturn]] void beyond_double(std::size_t byte) const { fail("the number is too large or too small", byte); }

 private:
  void move_to(std::vector<Point>& points, std::vector<std::uint32_t>& ends) {
    points.insert(points.end(), vertices_.begin(), vertices_.end());
    ends.push_back(static_cast<std::uint32_t>(points.size()));
    vertices_.clear();
  }

  OwnedShapes shapes_;
  std::vector<Point> vertices_;
  std::size_t contours_before_ = 0;
};

}  // namespace

OwnedShapes shapes_from_wkt(const std::string& text) { return ShapesOfWkt().read(text); }

}  // namespace oblast::testing
