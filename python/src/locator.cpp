// Points in regions.
#include <oblast/locator.h>

#include <optional>

#include "bindings.h"
#include "call.h"

namespace oblast::python {

namespace {

Locator make_locator(const Arrays& a, const Settings& settings) {
  std::optional<Locator> made;
  run(settings, {&a}, [&](const CallOptions& common) { made.emplace(a.regions(), common); });
  return std::move(*made);
}

nb::object locate(const Locator& locator, const PointsIn& points, const Settings& settings) {
  const std::span<const Point> queries{reinterpret_cast<const Point*>(points.data()), points.shape(0)};
  std::vector<std::int8_t> found(queries.size());
  run(
      settings, {},
      [&](const CallOptions& common) {
        std::vector<Location> locations(queries.size());
        locator.locate(queries, locations, common);
        for (std::size_t i = 0; i < found.size(); ++i) found[i] = static_cast<std::int8_t>(locations[i]);
      },
      true);
  return numpy_indices(std::move(found));
}

}  // namespace

void bind_locator(nb::module_& module) {
  nb::class_<Locator>(module, "Locator")
      .def("locate", &locate, nb::arg("points"), nb::arg("settings"),
           nb::sig("def locate(self, points: numpy.typing.NDArray[numpy.float64], settings: Settings) -> "
                   "numpy.typing.NDArray[numpy.int8]"));
  module.def("locator", &make_locator, nb::arg("a"), nb::arg("settings"));
}

}  // namespace oblast::python
