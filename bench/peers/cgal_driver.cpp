// CGAL: Boolean_set_operations_2 with exact predicates and exact constructions.
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/version.h>

#include "driver/driver.h"

namespace {

using namespace oblast;
using bench::OperandKind;

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using PolygonSet = CGAL::Polygon_set_2<Kernel>;
using Polygon = CGAL::Polygon_2<Kernel>;
using PolygonWithHoles = CGAL::Polygon_with_holes_2<Kernel>;

struct Cgal {
  static std::string name() { return "cgal"; }
  static std::string version() { return CGAL_VERSION_STR; }

  struct Prepared {
    std::vector<PolygonWithHoles> a, b;
  };

  explicit Cgal(const bench::Settings& settings) : settings_(settings) {
    if (settings.kind_a == OperandKind::crossing || settings.kind_b == OperandKind::crossing) {
      throw bench::Unsupported("contours that cross themselves are not valid input");
    }
  }

  Prepared prepare(const RegionView& a, const RegionView& b) { return {convert(a), convert(b)}; }

  void run(const Prepared& input, RegionSet& result) {
    PolygonSet a, b;
    a.join(input.a.begin(), input.a.end());
    if (!settings_.unary) {
      b.join(input.b.begin(), input.b.end());
      switch (settings_.operation) {
        case Operation::intersection:
          a.intersection(b);
          break;
        case Operation::unite:
          a.join(b);
          break;
        case Operation::difference:
          a.difference(b);
          break;
        case Operation::symmetric_difference:
          a.symmetric_difference(b);
          break;
      }
    }
    extract(a, result);
  }

 private:
  static std::vector<PolygonWithHoles> convert(const RegionView& regions) {
    const auto ring = [](std::span<const Point> contour) {
      Polygon polygon;
      for (const Point& p : contour) polygon.push_back({p.x, p.y});
      return polygon;
    };
    std::vector<PolygonWithHoles> converted;
    for (std::size_t p = 0; p < regions.polygon_count(); ++p) {
      const std::uint32_t outer = regions.polygon_begin(p);
      PolygonWithHoles polygon(ring(regions.contour(outer)));
      for (std::uint32_t c = outer + 1; c < regions.polygon_end(p); ++c) polygon.add_hole(ring(regions.contour(c)));
      converted.push_back(std::move(polygon));
    }
    return converted;
  }

  static void extract(const PolygonSet& set, RegionSet& result) {
    const auto ring = [&result](const Polygon& polygon) {
      for (const auto& p : polygon) result.points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y())});
      result.contour_ends.push_back(static_cast<std::uint32_t>(result.points.size()));
    };
    std::vector<PolygonWithHoles> polygons;
    set.polygons_with_holes(std::back_inserter(polygons));
    for (const PolygonWithHoles& polygon : polygons) {
      ring(polygon.outer_boundary());
      for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) ring(*hole);
      result.polygon_ends.push_back(static_cast<std::uint32_t>(result.contour_ends.size()));
    }
  }

  bench::Settings settings_;
};

}  // namespace

int main(int argc, char** argv) { return bench::drive<Cgal>(argc, argv); }
