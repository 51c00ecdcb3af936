// The extension: oblast._core. What a person calls is in python/oblast, which is written in Python.
#include <nanobind/nanobind.h>
#include <oblast/error.h>
#include <oblast/version.h>

#include <string>

#include "bindings.h"
#include "call.h"

NB_MODULE(_core, module) {
  using namespace oblast::python;
  module.attr("version") = std::to_string(OBLAST_VERSION_MAJOR) + "." + std::to_string(OBLAST_VERSION_MINOR) + "." +
                           std::to_string(OBLAST_VERSION_PATCH);
  // The usual settings live as long as the process; python/tests/test_memory.py looks for leaks.
  nb::set_leak_warnings(false);
  // What is thrown outside run(), where no operand is known.
  nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
    try {
      std::rethrow_exception(thrown);
    } catch (const oblast::Error& error) {
      try {
        raise_error(error, {});
      } catch (nb::python_error& raised) {
        raised.restore();
      }
    }
  });
  bind_arrays(module);
  bind_settings(module);
  bind_overlays(module);
  bind_rows(module);
  bind_buffer(module);
  bind_zones(module);
  bind_pairs(module);
  bind_locator(module);
  bind_wkb(module);
  bind_arrow(module);
}
