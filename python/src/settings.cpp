// What a call is told, as Python sets it.
#include <nanobind/nanobind.h>

#include "bindings.h"
#include "call.h"

namespace oblast::python {

void bind_settings(nb::module_& module) {
  note_forks();
  nb::class_<Workspace>(module, "Workspace")
      .def(nb::init<std::size_t>(), nb::arg("most_bytes"))
      .def("kept_bytes", &Workspace::kept_bytes)
      .def("clear", &Workspace::clear);
  nb::class_<Statistics>(module, "Statistics")
      .def(nb::init<>())
      .def_ro("input_contours", &Statistics::input_contours)
      .def_ro("input_vertices", &Statistics::input_vertices)
      .def_ro("output_polygons", &Statistics::output_polygons)
      .def_ro("output_contours", &Statistics::output_contours)
      .def_ro("output_vertices", &Statistics::output_vertices)
      .def_ro("resolved_polygons", &Statistics::resolved_polygons)
      .def_ro("intersections", &Statistics::intersections)
      .def_ro("rounds", &Statistics::rounds)
      .def_ro("largest_displacement", &Statistics::largest_displacement)
      .def_ro("largest_displacement_ulps", &Statistics::largest_displacement_ulps)
      .def(
          "seconds", [](const Statistics& s, int stage) { return s.seconds[stage]; }, nb::arg("stage"));
  nb::class_<Settings>(module, "Settings")
      .def(nb::init<>())
      .def(
          "set_threads", [](Settings& s, int threads) { s.options.threads = threads; }, nb::arg("threads"))
      .def(
          "set_memory", [](Settings& s, std::size_t bytes) { s.options.most_bytes = bytes; }, nb::arg("most_bytes"))
      .def(
          "set_progress", [](Settings& s, nb::object progress) { s.progress = std::move(progress); },
          nb::arg("progress"))
      .def(
          "set_workspace",
          [](Settings& s, nb::object workspace) {
            s.options.workspace = &nb::cast<Workspace&>(workspace);
            s.workspace = std::move(workspace);
          },
          nb::arg("workspace"), nb::sig("def set_workspace(self, workspace: Workspace) -> None"))
      .def(
          "set_statistics", [](Settings& s, Statistics& statistics) { s.options.statistics = &statistics; },
          nb::arg("statistics"), nb::keep_alive<1, 2>())
      .def(
          "set_fill",
          [](Settings& s, int operand, int kind, int depth) {
            (operand == 0 ? s.options.fill_a : s.options.fill_b) = {static_cast<FillRule::Kind>(kind), depth};
          },
          nb::arg("operand"), nb::arg("kind"), nb::arg("depth"))
      .def(
          "set_engine", [](Settings& s, int engine) { s.options.engine = static_cast<Engine>(engine); },
          nb::arg("engine"))
      .def(
          "set_touching",
          [](Settings& s, bool touching) {
            s.options.contours = touching ? ContourConvention::leonov_nikitin : ContourConvention::ogc;
          },
          nb::arg("touching"))
      .def(
          "set_minimal",
          [](Settings& s, bool minimal) {
            s.options.collinear = minimal ? CollinearVertices::drop : CollinearVertices::keep;
          },
          nb::arg("minimal"));
}

}  // namespace oblast::python
