// Overlay, union, hull, triangulation, check and measures.
#include <oblast/check.h>
#include <oblast/hull.h>
#include <oblast/measure.h>
#include <oblast/overlay.h>
#include <oblast/triangulate.h>

#include <algorithm>
#include <optional>

#include "bindings.h"
#include "call.h"

namespace oblast::python {

namespace {

// Has a call on these a fast path that progress would switch off? It is linear in the other operand, so it need not be
// watched. This only guesses: a wrong guess costs time, or a delay of Ctrl-C.
bool is_small_convex(const RegionView& regions) {
  constexpr std::size_t most_sides = 64;
  if (regions.contour_count() != 1 || regions.points.size() > most_sides + 1) return false;
  const auto points = regions.points;
  bool left = false, right = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point &p = points[i], &q = points[(i + 1) % points.size()], &r = points[(i + 2) % points.size()];
    const double turn = (q.x - p.x) * (r.y - q.y) - (q.y - p.y) * (r.x - q.x);
    (turn < 0 ? right : left) |= turn != 0;
  }
  return !(left && right);
}

Arrays overlay_of(const Arrays& a, const Arrays& b, int operation, const Settings& settings) {
  RegionSet result;
  const RegionView va = a.regions(), vb = b.regions();
  const bool quick =
      operation == static_cast<int>(Operation::intersection) && (is_small_convex(va) || is_small_convex(vb));
  run(
      settings, {&a, &b},
      [&](const CallOptions& common) {
        overlay(va, vb, static_cast<Operation>(operation), settings.with(common), result);
      },
      quick);
  return from_region_set(std::move(result));
}

Arrays unite_of(const Arrays& a, const Settings& settings) {
  RegionSet result;
  run(settings, {&a}, [&](const CallOptions& common) { unite(a.regions(), settings.with(common), result); });
  return from_region_set(std::move(result));
}

Arrays hull_of(const Arrays& a, const Settings& settings) {
  RegionSet result;
  run(settings, {&a}, [&](const CallOptions& common) { result = hull(a.regions(), common); });
  return from_region_set(std::move(result));
}

double area_of(const Arrays& a, const Settings& settings) {
  double result = 0;
  run(settings, {&a}, [&](const CallOptions& common) { result = area(a.regions(), common); });
  return result;
}

nb::object bounds_of(const Arrays& a, const Settings& settings) {
  std::optional<Box> box;
  run(settings, {&a}, [&](const CallOptions& common) { box = bounds(a.regions(), common); });
  if (!box) return nb::none();
  return nb::make_tuple(box->x0, box->y0, box->x1, box->y1);
}

constexpr const char* fault_names[] = {
    "bad_offsets",        "not_finite",         "out_of_domain",        "too_few_vertices", "repeated_vertex",
    "edges_cross",        "vertex_on_edge",     "edges_overlap",        "touches_itself",   "wrong_side",
    "outer_is_not_first", "hole_is_outer",      "other_polygon",        "not_connected",    "negative_zero",
    "wrong_start",        "holes_out_of_order", "polygons_out_of_order"};

nb::tuple place_of(const Place& place, const Arrays& a) {
  const auto index = [](std::size_t i) { return i == Place::npos ? nb::none() : nb::object(nb::int_(i)); };
  const std::size_t row = place.contour == Place::npos ? Place::npos : a.row_of_ring(place.contour);
  return nb::make_tuple(index(row), index(place.polygon), index(place.contour), index(place.vertex));
}

nb::object check_of(const Arrays& a, bool touching, bool canonical, const Settings& settings) {
  CheckReport report;
  run(settings, {&a}, [&](const CallOptions& common) {
    CheckOptions options{common};
    options.contours = touching ? ContourConvention::leonov_nikitin : ContourConvention::ogc;
    options.order = canonical ? CheckedOrder::canonical : CheckedOrder::any;
    report = check(a.regions(), options);
  });
  if (!report.fault) return nb::none();
  const Fault& fault = *report.fault;
  return nb::make_tuple(fault_names[static_cast<int>(fault.kind)], fault.message, place_of(fault.place, a),
                        place_of(fault.other, a), nb::make_tuple(fault.point.x, fault.point.y));
}

nb::tuple triangulate_of(const Arrays& a, bool convex_hull, bool is_result, const Settings& settings) {
  Triangulation t;
  run(settings, {&a}, [&](const CallOptions& common) {
    TriangulateOptions options;
    static_cast<Options&>(options) = settings.with(common);
    options.extent = convex_hull ? TriangleExtent::convex_hull : TriangleExtent::interior;
    options.input = is_result ? TriangleInput::result : TriangleInput::any;
    t = triangulate(a.regions(), options);
  });
  return nb::make_tuple(from_region_set(std::move(t.regions)), numpy_points(std::move(t.points)),
                        numpy_triples(std::move(t.triangles)), numpy_triples(std::move(t.neighbours)),
                        numpy_triples(std::move(t.is_side)), numpy_indices(std::move(t.polygon)));
}

}  // namespace

void bind_overlays(nb::module_& module) {
  module.def("overlay", &overlay_of, nb::arg("a"), nb::arg("b"), nb::arg("operation"), nb::arg("settings"));
  module.def("unite", &unite_of, nb::arg("a"), nb::arg("settings"));
  module.def("hull", &hull_of, nb::arg("a"), nb::arg("settings"));
  module.def("area", &area_of, nb::arg("a"), nb::arg("settings"));
  module.def("bounds", &bounds_of, nb::arg("a"), nb::arg("settings"),
             nb::sig("def bounds(a: Arrays, settings: Settings) -> tuple[float, float, float, float] | None"));
  module.def("check", &check_of, nb::arg("a"), nb::arg("touching"), nb::arg("canonical"), nb::arg("settings"),
             nb::sig("def check(a: Arrays, touching: bool, canonical: bool, settings: Settings) -> "
                     "tuple[str, str, tuple[int | None, int | None, int | None, int | None], "
                     "tuple[int | None, int | None, int | None, int | None], tuple[float, float]] | None"));
  module.def("triangulate", &triangulate_of, nb::arg("a"), nb::arg("convex_hull"), nb::arg("is_result"),
             nb::arg("settings"),
             nb::sig("def triangulate(a: Arrays, convex_hull: bool, is_result: bool, settings: Settings) -> "
                     "tuple[Arrays, numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.uint32], "
                     "numpy.typing.NDArray[numpy.uint32], numpy.typing.NDArray[numpy.bool_], "
                     "numpy.typing.NDArray[numpy.uint32]]"));
}

}  // namespace oblast::python
