// Buffer zones of regions, lines and points.
#include <oblast/buffer.h>
#include <oblast/overlay.h>

#include <vector>

#include "bindings.h"
#include "call.h"
#include "shapes.h"

namespace oblast::python {

namespace {

using Distances = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

// What Python says about the shape of zones, apart from the distance.
struct BufferShape {
  int join = 0, cap = 0, side = 0, mode = 0;
  double mitre_limit = 5, tolerance = 0.01, absolute_tolerance = 0;
};

// The statistics of the overlay are those that `oblast.statistics` collects.
BufferOptions options_of(const BufferShape& shape, const Settings& settings, const CallOptions& common,
                         BufferStatistics& statistics) {
  BufferOptions options;
  static_cast<CallOptions&>(options) = common;
  options.fill = settings.options.fill_a;
  options.join = static_cast<Join>(shape.join);
  options.cap = static_cast<Cap>(shape.cap);
  options.side = static_cast<Side>(shape.side);
  options.mode = static_cast<BufferMode>(shape.mode);
  options.mitre_limit = shape.mitre_limit;
  options.tolerance = shape.tolerance;
  options.absolute_tolerance = shape.absolute_tolerance;
  if (settings.options.statistics) options.statistics = &statistics;
  return options;
}

Arrays buffer_of(const Arrays& regions, const Arrays& lines, const Arrays& points, double distance,
                 const BufferShape& shape, const Settings& settings) {
  RegionSet zone;
  run(settings, {&regions, &lines, &points}, [&](const CallOptions& common) {
    BufferStatistics statistics;
    const BufferOptions options = options_of(shape, settings, common, statistics);
    zone = buffer(shapes_of(regions, lines, points), distance, options);
    if (settings.options.statistics) *settings.options.statistics = statistics.overlay;
  });
  return from_region_set(std::move(zone));
}

Arrays buffer_rows_of(const Arrays& regions, const Arrays& lines, const Arrays& points, const Distances& distances,
                      const BufferShape& shape, bool united, const Settings& settings) {
  FeatureSet zones;
  RegionSet zone;
  run(settings, {&regions, &lines, &points}, [&](const CallOptions& common) {
    BufferStatistics statistics;
    const BufferOptions options = options_of(shape, settings, common, statistics);
    const std::vector<std::uint32_t> region_rows = rows_of_polygons(regions), line_rows = rows_of_rings(lines),
                                     point_rows = rows_of_rings(points);
    zones = buffer_rows({shapes_of(regions, lines, points), region_rows, line_rows, point_rows},
                        {distances.data(), distances.shape(0)}, options);
    if (settings.options.statistics) *settings.options.statistics = statistics.overlay;
    if (!united) return;
    Options uniting;
    static_cast<CallOptions&>(uniting) = common;
    zone = unite(zones.regions, uniting);
  });
  return united ? from_region_set(std::move(zone)) : from_features(std::move(zones));
}

}  // namespace

void bind_buffer(nb::module_& module) {
  nb::class_<BufferShape>(module, "BufferShape")
      .def(
          "__init__",
          [](BufferShape* made, int join, int cap, int side, int mode, double mitre_limit, double tolerance,
             double absolute_tolerance) {
            new (made) BufferShape{join, cap, side, mode, mitre_limit, tolerance, absolute_tolerance};
          },
          nb::arg("join"), nb::arg("cap"), nb::arg("side"), nb::arg("mode"), nb::arg("mitre_limit"),
          nb::arg("tolerance"), nb::arg("absolute_tolerance"));
  module.def("buffer", &buffer_of, nb::arg("regions"), nb::arg("lines"), nb::arg("points"), nb::arg("distance"),
             nb::arg("shape"), nb::arg("settings"));
  module.def("buffer_rows", &buffer_rows_of, nb::arg("regions"), nb::arg("lines"), nb::arg("points"),
             nb::arg("distances"), nb::arg("shape"), nb::arg("united"), nb::arg("settings"),
             nb::sig("def buffer_rows(regions: Arrays, lines: Arrays, points: Arrays, "
                     "distances: numpy.typing.NDArray[numpy.float64], shape: BufferShape, united: bool, "
                     "settings: Settings) -> Arrays"));
}

}  // namespace oblast::python
