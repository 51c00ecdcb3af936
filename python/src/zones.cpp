// Proximity zones of regions, lines and points.
#include <oblast/zones.h>

#include <vector>

#include "bindings.h"
#include "call.h"
#include "shapes.h"

namespace oblast::python {

namespace {

using Groups = nb::ndarray<const std::uint32_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

// The object of each shape, in place of its row.
std::vector<std::uint32_t> objects_of(std::vector<std::uint32_t> rows, const Groups& groups) {
  for (std::uint32_t& row : rows) row = groups.data()[row];
  return rows;
}

nb::tuple zones_of(const Arrays& regions, const Arrays& lines, const Arrays& points, const Arrays& frame,
                   const Groups& groups, std::uint32_t count, double tolerance, double relative_tolerance,
                   double distance, const Settings& settings) {
  if (groups.shape(0) != regions.row_count()) throw nb::value_error("one group for each row");
  FeatureSet zones;
  ZoneStatistics statistics;
  run(settings, {&regions, &lines, &points, &frame}, [&](const CallOptions& common) {
    ZoneOptions options;
    static_cast<CallOptions&>(options) = common;
    options.tolerance = tolerance;
    options.relative_tolerance = relative_tolerance;
    options.distance = distance;
    options.statistics = &statistics;
    const std::vector<std::uint32_t> of_regions = objects_of(rows_of_polygons(regions), groups),
                                     of_lines = objects_of(rows_of_rings(lines), groups),
                                     of_points = objects_of(rows_of_rings(points), groups);
    zones =
        oblast::zones({shapes_of(regions, lines, points), of_regions, of_lines, of_points}, frame.regions(), options);
    // The last objects may have no shapes.
    zones.feature_ends.resize(count, static_cast<std::uint32_t>(zones.regions.polygon_ends.size()));
    if (settings.options.statistics) *settings.options.statistics = statistics.overlay;
  });
  return nb::make_tuple(from_features(std::move(zones)), statistics.error, statistics.rounding);
}

}  // namespace

void bind_zones(nb::module_& module) {
  module.def("zones", &zones_of, nb::arg("regions"), nb::arg("lines"), nb::arg("points"), nb::arg("frame"),
             nb::arg("groups"), nb::arg("count"), nb::arg("tolerance"), nb::arg("relative_tolerance"),
             nb::arg("distance"), nb::arg("settings"),
             nb::sig("def zones(regions: Arrays, lines: Arrays, points: Arrays, frame: Arrays, "
                     "groups: numpy.typing.NDArray[numpy.uint32], count: int, tolerance: float, "
                     "relative_tolerance: float, distance: float, settings: Settings) -> "
                     "tuple[Arrays, float, float]"));
}

}  // namespace oblast::python
