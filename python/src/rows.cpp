// Layers: overlay of rows, dissolve, depth, partition.
#include <oblast/features.h>

#include <vector>

#include "bindings.h"
#include "call.h"

namespace oblast::python {

namespace {

using Groups = nb::ndarray<const std::uint32_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

std::span<const std::uint32_t> span_of(const Groups& groups) { return {groups.data(), groups.shape(0)}; }

// One member of each key, as signed numbers: -1 where there is no row.
nb::object keys_of(const std::vector<FeatureKey>& keys, std::uint32_t FeatureKey::*member) {
  std::vector<std::int64_t> indices;
  indices.reserve(keys.size());
  for (const FeatureKey& key : keys)
    indices.push_back(key.*member == no_feature ? -1 : static_cast<std::int64_t>(key.*member));
  return numpy_indices(std::move(indices));
}

nb::tuple overlay_features_of(const Arrays& a, const Arrays& b, int operation, const Settings& settings) {
  FeatureSet rows;
  run(settings, {&a, &b}, [&](const CallOptions& common) {
    rows =
        overlay_features(a.features(), b.features(), static_cast<FeatureOperation>(operation), settings.with(common));
  });
  nb::object i = keys_of(rows.keys, &FeatureKey::a), j = keys_of(rows.keys, &FeatureKey::b);
  return nb::make_tuple(from_features(std::move(rows)), i, j);
}

Arrays dissolve_of(const Arrays& a, const Groups& groups, const Settings& settings) {
  FeatureSet rows;
  run(settings, {&a},
      [&](const CallOptions& common) { rows = dissolve(a.features(), span_of(groups), settings.with(common)); });
  return from_features(std::move(rows));
}

nb::tuple depth_of(const Arrays& a, const Groups& groups, const Settings& settings) {
  FeatureSet rows;
  run(settings, {&a},
      [&](const CallOptions& common) { rows = depth(a.features(), span_of(groups), settings.with(common)); });
  nb::object depths = keys_of(rows.keys, &FeatureKey::a);
  return nb::make_tuple(from_features(std::move(rows)), depths);
}

nb::tuple partition_of(const std::vector<const Arrays*>& layers, const Settings& settings) {
  Partition result;
  std::vector<FeatureView> views;
  for (const Arrays* layer : layers) views.push_back(layer->features());
  run(settings, layers, [&](const CallOptions& common) { result = partition(views, settings.with(common)); });
  std::vector<std::uint32_t> layer, row, offsets{0};
  offsets.insert(offsets.end(), result.source_ends.begin(), result.source_ends.end());
  for (const FeatureSource& source : result.sources) {
    layer.push_back(source.layer);
    row.push_back(source.feature);
  }
  return nb::make_tuple(from_features(std::move(result.rows)), numpy_indices(std::move(offsets)),
                        numpy_indices(std::move(layer)), numpy_indices(std::move(row)));
}

}  // namespace

void bind_rows(nb::module_& module) {
  module.def("overlay_features", &overlay_features_of, nb::arg("a"), nb::arg("b"), nb::arg("operation"),
             nb::arg("settings"),
             nb::sig("def overlay_features(a: Arrays, b: Arrays, operation: int, settings: Settings) -> "
                     "tuple[Arrays, numpy.typing.NDArray[numpy.int64], numpy.typing.NDArray[numpy.int64]]"));
  module.def(
      "dissolve", &dissolve_of, nb::arg("a"), nb::arg("groups"), nb::arg("settings"),
      nb::sig("def dissolve(a: Arrays, groups: numpy.typing.NDArray[numpy.uint32], settings: Settings) -> Arrays"));
  module.def("depth", &depth_of, nb::arg("a"), nb::arg("groups"), nb::arg("settings"),
             nb::sig("def depth(a: Arrays, groups: numpy.typing.NDArray[numpy.uint32], settings: Settings) -> "
                     "tuple[Arrays, numpy.typing.NDArray[numpy.int64]]"));
  module.def("partition", &partition_of, nb::arg("layers"), nb::arg("settings"),
             nb::sig("def partition(layers: list[Arrays], settings: Settings) -> "
                     "tuple[Arrays, numpy.typing.NDArray[numpy.uint32], numpy.typing.NDArray[numpy.uint32], "
                     "numpy.typing.NDArray[numpy.uint32]]"));
}

}  // namespace oblast::python
