#include "arrays.h"

#include <nanobind/stl/vector.h>

#include <algorithm>
#include <string>

#include "blocks.h"

namespace oblast::python {

namespace {

Offsets offsets_of(std::vector<std::uint32_t>&& ends) {
  ends.insert(ends.begin(), 0);
  return std::move(ends);
}

// A numpy array lives as long as this; it is let go while the lock is held (Arrays ends in a Python object).
template <class Array>
std::shared_ptr<const void> keeper(const Array& array) {
  return std::make_shared<Array>(array);
}

std::span<const std::uint32_t> as_unsigned(const OffsetsIn& offsets) {
  return {reinterpret_cast<const std::uint32_t*>(offsets.data()), offsets.shape(0)};
}

template <class T>
bool same(std::span<const T> a, std::span<const T> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

bool same_arrays(const Arrays& a, const Arrays& b) {
  return same(a.row_offsets, b.row_offsets) && same(a.polygon_offsets, b.polygon_offsets) &&
         same(a.ring_offsets, b.ring_offsets) && same(a.points, b.points);
}

nb::object view_of(nb::handle self, std::span<const std::uint32_t> offsets) {
  const auto* data = reinterpret_cast<const std::int32_t*>(offsets.data());
  return nb::cast(nb::ndarray<nb::numpy, const std::int32_t, nb::ndim<1>>(data, {offsets.size()}, self));
}

nb::object points_of(nb::handle self) {
  static const Point none{};
  const auto points = nb::cast<const Arrays&>(self).points;
  const auto* data = &(points.empty() ? &none : points.data())->x;
  return nb::cast(nb::ndarray<nb::numpy, const double, nb::shape<-1, 2>>(data, {points.size(), 2}, self));
}

}  // namespace

RegionView Arrays::row(std::size_t row) const {
  const std::uint32_t p0 = row_offsets[row], p1 = row_offsets[row + 1];
  const std::uint32_t r0 = polygon_offsets[p0], r1 = polygon_offsets[p1];
  if (r0 == r1) return {};
  const std::uint32_t v0 = ring_offsets[r0], v1 = ring_offsets[r1];
  return {points.subspan(v0, v1 - v0), ring_offsets.subspan(r0 + 1, r1 - r0), polygon_offsets.subspan(p0 + 1, p1 - p0),
          v0, r0};
}

std::size_t Arrays::row_of_ring(std::size_t ring) const {
  const auto before = [](std::span<const std::uint32_t> offsets, std::size_t index) {
    return static_cast<std::size_t>(std::upper_bound(offsets.begin(), offsets.end(), index) - offsets.begin()) - 1;
  };
  return before(row_offsets, before(polygon_offsets, ring));
}

Arrays from_features(FeatureSet&& rows) {
  Arrays arrays;
  arrays.points = arrays.own(std::move(rows.regions.points));
  arrays.ring_offsets = arrays.own(offsets_of(std::move(rows.regions.contour_ends)));
  arrays.polygon_offsets = arrays.own(offsets_of(std::move(rows.regions.polygon_ends)));
  arrays.row_offsets = arrays.own(offsets_of(std::move(rows.feature_ends)));
  return arrays;
}

Arrays from_region_set(RegionSet&& regions) {
  FeatureSet rows;
  rows.feature_ends = {static_cast<std::uint32_t>(regions.polygon_ends.size())};
  rows.regions = std::move(regions);
  return from_features(std::move(rows));
}

void require_offsets(std::span<const std::uint32_t> offsets, std::size_t count, const char* name) {
  const auto fail = [&](const std::string& what) { throw nb::value_error((name + (" " + what)).c_str()); };
  if (offsets.empty() || offsets.front() != 0) fail("must begin with 0");
  const auto step = std::adjacent_find(offsets.begin(), offsets.end(), std::greater<>());
  if (step != offsets.end()) fail("decrease at index " + std::to_string(step - offsets.begin() + 1));
  if (offsets.back() != count)
    fail("must end with " + std::to_string(count) + ", the number of what they divide, not " +
         std::to_string(offsets.back()));
}

Arrays from_numpy(const PointsIn& points, const OffsetsIn& rings, const OffsetsIn& polygons, const OffsetsIn& rows) {
  Arrays arrays;
  arrays.points = {reinterpret_cast<const Point*>(points.data()), points.shape(0)};
  arrays.ring_offsets = as_unsigned(rings);
  arrays.polygon_offsets = as_unsigned(polygons);
  arrays.row_offsets = as_unsigned(rows);
  require_offsets(arrays.ring_offsets, arrays.points.size(), "ring_offsets");
  require_offsets(arrays.polygon_offsets, arrays.ring_offsets.size() - 1, "polygon_offsets");
  require_offsets(arrays.row_offsets, arrays.polygon_offsets.size() - 1, "row_offsets");
  arrays.keep(keeper(points));
  for (const OffsetsIn* offsets : {&rings, &polygons, &rows}) arrays.keep(keeper(*offsets));
  return arrays;
}

Arrays take_rows(const Arrays& from, std::span<const std::int64_t> rows) {
  FeatureSet taken;
  for (const std::int64_t row : rows) add_row(taken, from.row(static_cast<std::size_t>(row)));
  return from_features(std::move(taken));
}

Arrays concatenate(std::span<const Arrays* const> parts) {
  FeatureSet all;
  std::size_t points = 0;
  for (const Arrays* part : parts) points += part->points.size();
  all.regions.points.reserve(points);
  for (const Arrays* part : parts) add_rows(all, part->features());
  return from_features(std::move(all));
}

Arrays opened(const Arrays& rows) {
  const auto is_closed = [](std::span<const Point> ring) { return ring.size() > 1 && ring.front() == ring.back(); };
  const ContourRange rings = rows.regions().contours();
  if (std::none_of(rings.begin(), rings.end(), is_closed)) return rows;
  std::vector<Point> points;
  points.reserve(rows.points.size());
  Offsets offsets{0};
  for (const std::span<const Point> ring : rings) {
    points.insert(points.end(), ring.begin(), ring.end() - is_closed(ring));
    offsets.push_back(static_cast<std::uint32_t>(points.size()));
  }
  Arrays result = rows;
  result.points = result.own(std::move(points));
  result.ring_offsets = result.own(std::move(offsets));
  return result;
}

void bind_arrays(nb::module_& module) {
  nb::class_<Arrays>(module, "Arrays", "Points and offsets that the library reads; oblast.Regions holds one.")
      .def_prop_ro(
          "points", [](nb::handle self) { return points_of(self); },
          nb::sig("def points(self) -> numpy.typing.NDArray[numpy.float64]"))
      .def_prop_ro(
          "ring_offsets", [](nb::handle self) { return view_of(self, nb::cast<const Arrays&>(self).ring_offsets); },
          nb::sig("def ring_offsets(self) -> numpy.typing.NDArray[numpy.int32]"))
      .def_prop_ro(
          "polygon_offsets",
          [](nb::handle self) { return view_of(self, nb::cast<const Arrays&>(self).polygon_offsets); },
          nb::sig("def polygon_offsets(self) -> numpy.typing.NDArray[numpy.int32]"))
      .def_prop_ro(
          "row_offsets", [](nb::handle self) { return view_of(self, nb::cast<const Arrays&>(self).row_offsets); },
          nb::sig("def row_offsets(self) -> numpy.typing.NDArray[numpy.int32]"))
      .def("row_count", &Arrays::row_count)
      .def("opened", &opened)
      .def("same", &same_arrays, nb::arg("other"))
      .def(
          "take",
          [](const Arrays& self,
             const nb::ndarray<const std::int64_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>& rows) {
            return take_rows(self, {rows.data(), rows.shape(0)});
          },
          nb::arg("rows"), nb::sig("def take(self, rows: numpy.typing.NDArray[numpy.int64]) -> Arrays"));
  module.def(
      "concatenate", [](const std::vector<const Arrays*>& parts) { return concatenate(parts); }, nb::arg("parts"),
      nb::sig("def concatenate(parts: list[Arrays]) -> Arrays"));
  module.def("arrays", &from_numpy, nb::arg("points"), nb::arg("ring_offsets"), nb::arg("polygon_offsets"),
             nb::arg("row_offsets"),
             nb::sig("def arrays(points: numpy.typing.NDArray[numpy.float64], "
                     "ring_offsets: numpy.typing.NDArray[numpy.int32], "
                     "polygon_offsets: numpy.typing.NDArray[numpy.int32], "
                     "row_offsets: numpy.typing.NDArray[numpy.int32]) -> Arrays"));
}

}  // namespace oblast::python
