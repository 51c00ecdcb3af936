// What the files of the extension add to the module, and arrays of results for numpy.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>
#include <oblast/point.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace oblast::python {

namespace nb = nanobind;

void bind_settings(nb::module_& module);
void bind_overlays(nb::module_& module);
void bind_rows(nb::module_& module);
void bind_buffer(nb::module_& module);
void bind_zones(nb::module_& module);
void bind_pairs(nb::module_& module);
void bind_locator(nb::module_& module);
void bind_wkb(nb::module_& module);
void bind_arrow(nb::module_& module);

/// A vector becomes a numpy array that owns it; nothing is copied. `Element` is the type of the numbers in a T.
template <class Element, class T>
nb::object numpy_of(std::vector<T>&& values, std::size_t width) {
  auto* owned = new std::vector<T>(std::move(values));
  const nb::capsule owner(owned, [](void* p) noexcept { delete static_cast<std::vector<T>*>(p); });
  auto* data = reinterpret_cast<Element*>(owned->data());
  if (width == 1) return nb::cast(nb::ndarray<nb::numpy, Element, nb::ndim<1>>(data, {owned->size()}, owner));
  return nb::cast(nb::ndarray<nb::numpy, Element, nb::ndim<2>>(data, {owned->size(), width}, owner));
}

inline nb::object numpy_points(std::vector<Point>&& points) { return numpy_of<double>(std::move(points), 2); }
template <class T>
nb::object numpy_triples(std::vector<std::array<T, 3>>&& triples) {
  return numpy_of<T>(std::move(triples), 3);
}
template <class T>
nb::object numpy_indices(std::vector<T>&& indices) {
  return numpy_of<T>(std::move(indices), 1);
}

}  // namespace oblast::python
