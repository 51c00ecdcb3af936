#include "buffer/wkt_shapes.h"

#include <cctype>
#include <cstdlib>
#include <stdexcept>

namespace oblast::testing {
namespace {

class Reader {
 public:
  explicit Reader(const std::string& text) : at_(text.c_str()) {}

  OwnedShapes read() {
    geometry();
    return std::move(shapes_);
  }

 private:
  std::string word() {
    skip();
    std::string word;
    while (std::isalpha(static_cast<unsigned char>(*at_))) word += *at_++;
    return word;
  }
  void skip() {
    while (std::isspace(static_cast<unsigned char>(*at_))) ++at_;
  }
  bool take(char c) {
    skip();
    if (*at_ != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (!take(c)) throw std::runtime_error(std::string("expected ") + c + " before: " + at_);
  }
  bool is_empty() {
    skip();
    if (*at_ != 'E') return false;
    word();
    return true;
  }

  Point point() {
    char* end = nullptr;
    Point p;
    p.x = std::strtod(at_, &end), at_ = end;
    p.y = std::strtod(at_, &end), at_ = end;
    return p;
  }
  template <class Item>
  void list(const Item& item) {
    if (is_empty()) return;
    expect('(');
    do item();
    while (take(','));
    expect(')');
  }
  std::vector<Point> path() {
    std::vector<Point> points;
    list([&] { points.push_back(point()); });
    return points;
  }

  void add_point() {
    const bool in_brackets = take('(');
    shapes_.points.push_back(point());
    if (in_brackets) expect(')');
  }
  void add_line() {
    const std::vector<Point> points = path();
    shapes_.line_points.insert(shapes_.line_points.end(), points.begin(), points.end());
    shapes_.line_ends.push_back(static_cast<std::uint32_t>(shapes_.line_points.size()));
  }
  void add_polygon() {
    RegionSet& set = shapes_.regions;
    list([&] {
      const std::vector<Point> ring = path();
      set.points.insert(set.points.end(), ring.begin(), ring.end());
      set.contour_ends.push_back(static_cast<std::uint32_t>(set.points.size()));
    });
    if (set.polygon_ends.empty() ? !set.contour_ends.empty() : set.polygon_ends.back() < set.contour_ends.size())
      set.polygon_ends.push_back(static_cast<std::uint32_t>(set.contour_ends.size()));
  }

  void geometry() {
    const std::string kind = word();
    if (kind == "POINT") {
      if (!is_empty()) add_point();
    } else if (kind == "MULTIPOINT") {
      list([&] { add_point(); });
    } else if (kind == "LINESTRING") {
      add_line();
    } else if (kind == "MULTILINESTRING") {
      list([&] { add_line(); });
    } else if (kind == "POLYGON") {
      add_polygon();
    } else if (kind == "MULTIPOLYGON") {
      list([&] { add_polygon(); });
    } else if (kind == "GEOMETRYCOLLECTION") {
      list([&] { geometry(); });
    } else {
      throw std::runtime_error("unknown geometry: " + kind);
    }
  }

  const char* at_;
  OwnedShapes shapes_;
};

}  // namespace

OwnedShapes shapes_from_wkt(const std::string& text) { return Reader(text).read(); }

}  // namespace oblast::testing
