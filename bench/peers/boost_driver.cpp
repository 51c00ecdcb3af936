// Boost.Geometry. It has no union of many polygons: they are united pairwise, neighbours first.
#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/version.hpp>
#include <limits>

#include "driver/driver.h"
#include "peers/neighbours_first.h"

namespace {

namespace geometry = boost::geometry;
using namespace oblast;
using bench::OperandKind;

constexpr bool clockwise = false;
constexpr bool closed = false;
using BoostPoint = geometry::model::d2::point_xy<double>;
using Polygon = geometry::model::polygon<BoostPoint, clockwise, closed>;
using MultiPolygon = geometry::model::multi_polygon<Polygon>;

struct Boost {
  static std::string name() { return "boost"; }
  static std::string version() {
    return std::to_string(BOOST_VERSION / 100000) + "." + std::to_string(BOOST_VERSION / 100 % 1000);
  }

  struct Prepared {
    MultiPolygon a, b;
  };

  explicit Boost(const bench::Settings& settings) : settings_(settings) {
    if (settings.kind_a == OperandKind::crossing || settings.kind_b == OperandKind::crossing) {
      throw bench::Unsupported("contours that cross themselves are not valid input");
    }
  }

  Prepared prepare(const RegionView& a, const RegionView& b) { return {convert(a), convert(b)}; }

  void run(const Prepared& input, RegionSet& result) {
    MultiPolygon united_a, united_b;
    if (settings_.kind_a == OperandKind::overlapping) united_a = unite(input.a);
    if (settings_.kind_b == OperandKind::overlapping) united_b = unite(input.b);
    const MultiPolygon& a = settings_.kind_a == OperandKind::overlapping ? united_a : input.a;
    const MultiPolygon& b = settings_.kind_b == OperandKind::overlapping ? united_b : input.b;
    if (settings_.unary) {
      extract(a, result);
      return;
    }
    MultiPolygon overlaid;
    switch (settings_.operation) {
      case Operation::intersection:
        geometry::intersection(a, b, overlaid);
        break;
      case Operation::unite:
        geometry::union_(a, b, overlaid);
        break;
      case Operation::difference:
        geometry::difference(a, b, overlaid);
        break;
      case Operation::symmetric_difference:
        geometry::sym_difference(a, b, overlaid);
        break;
    }
    extract(overlaid, result);
  }

 private:
  static MultiPolygon convert(const RegionView& regions) {
    const auto ring = [](std::span<const Point> contour, auto& target) {
      for (const Point& p : contour) target.push_back({p.x, p.y});
    };
    MultiPolygon converted;
    converted.resize(regions.polygon_count());
    for (std::size_t p = 0; p < regions.polygon_count(); ++p) {
      const std::uint32_t outer = regions.polygon_begin(p);
      ring(regions.contour(outer), converted[p].outer());
      converted[p].inners().resize(regions.polygon_end(p) - outer - 1);
      for (std::uint32_t c = outer + 1; c < regions.polygon_end(p); ++c) {
        ring(regions.contour(c), converted[p].inners()[c - outer - 1]);
      }
    }
    return converted;
  }

  static MultiPolygon unite(const MultiPolygon& polygons) {
    std::vector<std::pair<Point, MultiPolygon>> parts;
    for (const Polygon& polygon : polygons) {
      const BoostPoint& p = polygon.outer().front();
      parts.push_back({{p.x(), p.y()}, {polygon}});
    }
    return bench::unite_neighbours_first<MultiPolygon>(std::move(parts), [](MultiPolygon& a, MultiPolygon& b) {
      MultiPolygon both;
      geometry::union_(a, b, both);
      return both;
    });
  }

  static void extract(const MultiPolygon& polygons, RegionSet& result) {
    const auto ring = [&result](const auto& points) {
      for (const BoostPoint& p : points) result.points.push_back({p.x(), p.y()});
      result.contour_ends.push_back(static_cast<std::uint32_t>(result.points.size()));
    };
    for (const Polygon& polygon : polygons) {
      ring(polygon.outer());
      for (const auto& inner : polygon.inners()) ring(inner);
      result.polygon_ends.push_back(static_cast<std::uint32_t>(result.contour_ends.size()));
    }
  }

  bench::Settings settings_;
};

}  // namespace

int main(int argc, char** argv) { return bench::drive<Boost>(argc, argv); }
