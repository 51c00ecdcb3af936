#include <oblast/error.h>
#include <oblast/features.h>

#include <algorithm>
#include <string>

#include "base/check_options.h"
#include "base/public_call.h"
#include "features/keyed_overlay.h"
#include "features/validate_features.h"
#include "overlay/report.h"

namespace oblast {
using namespace internal;
namespace {

void check_rule(const FillRule& rule, const char* name) {
  if (!rule.by_polygon())
    throw Error(ErrorCode::bad_option, std::string(name) + " must read polygons one by one, where rows are overlaid");
}

void check_feature_options(const Options& options) {
  check_overlay_options(options);
  check_rule(options.fill_a, "fill_a");
  check_rule(options.fill_b, "fill_b");
  if (options.engine != Engine::leonov_nikitin)
    throw Error(ErrorCode::bad_option, "rows are overlaid by one engine: leave engine as it is");
}

void check_groups(const FeatureView& features, std::span<const std::uint32_t> groups) {
  if (groups.size() != features.feature_count())
    throw Error(ErrorCode::bad_option, std::to_string(groups.size()) + " groups for " +
                                           std::to_string(features.feature_count()) + " features");
}

/// By polygon: the source that its feature is.
template <class SourceOf>
Array<std::uint32_t> sources_of_polygons(const FeatureView& layer, const SourceOf& source_of) {
  Array<std::uint32_t> sources(layer.regions.polygon_count());
  for (std::size_t f = 0; f < layer.feature_count(); ++f)
    std::fill(sources.begin() + layer.feature_begin(f), sources.begin() + layer.feature_end(f), source_of(f));
  return sources;
}

/// The layers as operands; source_of(layer, feature) numbers the sources.
struct KeyedCall {
  std::span<const FeatureView> layers;
  bool second_is_b;
  std::size_t source_count;
  KeyRule rule;
  PartNeeds needs;
};

template <class SourceOf, class Finish>
auto run(const KeyedCall& call, const Options& options, const SourceOf& source_of, const Finish& finish) {
  check_feature_options(options);
  std::size_t vertices = 0, polygons = 0;
  for (const FeatureView& layer : call.layers) {
    vertices += layer.regions.points.size();
    polygons += layer.regions.polygon_count();
  }
  check_count(polygons, "polygons in one call");
  return public_call(options, options.statistics != nullptr, vertices, [&](Control& control) {
    for (std::size_t i = 0; i < call.layers.size(); ++i) validate_features(call.layers[i], i);
    Array<Array<std::uint32_t>> sources;
    Array<Operand> operands;
    for (std::size_t i = 0; i < call.layers.size(); ++i)
      sources.push_back(sources_of_polygons(call.layers[i], [&](std::size_t f) { return source_of(i, f); }));
    for (std::size_t i = 0; i < call.layers.size(); ++i) {
      const bool is_b = call.second_is_b && i == 1;
      operands.push_back({call.layers[i].regions, is_b, is_b ? options.fill_b : options.fill_a, sources[i]});
    }
    Statistics statistics;
    KeyedResult result =
        keyed_overlay({operands, call.source_count, call.rule, call.needs, options, control}, statistics);
    if (options.statistics) {
      Array<RegionView> regions;
      for (const FeatureView& layer : call.layers) regions.push_back(layer.regions);
      report(regions, result.regions, statistics);
      *options.statistics = statistics;
    }
    return finish(std::move(result));
  });
}

FeatureSet to_features(KeyedResult result) {
  FeatureSet features{std::move(result.regions), std::move(result.feature_ends), {}};
  features.keys.reserve(result.keys.size());
  for (const RowKey key : result.keys) features.keys.push_back(feature_key(key));
  return features;
}

PartNeeds needs_of(FeatureOperation operation) {
  using enum FeatureOperation;
  return {operation == intersection || operation == identity || operation == difference, operation == intersection};
}

}  // namespace

FeatureSet overlay_features(const FeatureView& a, const FeatureView& b, FeatureOperation operation,
                            const Options& options) {
  check_enumerator(operation, FeatureOperation::symmetric_difference, "FeatureOperation");
  const FeatureView layers[] = {a, b};
  return run(
      {layers, true, std::max(a.feature_count(), b.feature_count()), KeyRule::of(operation), needs_of(operation)},
      options, [](std::size_t, std::size_t f) { return static_cast<std::uint32_t>(f); }, to_features);
}

FeatureSet dissolve(const FeatureView& features, std::span<const std::uint32_t> groups, const Options& options) {
  check_groups(features, groups);
  const std::size_t group_count = groups.empty() ? 0 : std::size_t{1} + *std::max_element(groups.begin(), groups.end());
  return run(
      {{&features, 1}, false, group_count, KeyRule::each(), {}}, options,
      [&](std::size_t, std::size_t f) { return groups[f]; },
      [&](KeyedResult result) {
        FeatureSet rows{std::move(result.regions), {}, {}};
        std::uint32_t end = 0;
        for (std::uint32_t g = 0, next = 0; g < group_count; ++g) {
          if (next < result.keys.size() && feature_key(result.keys[next]).a == g) end = result.feature_ends[next++];
          rows.feature_ends.push_back(end);
          rows.keys.push_back({g, no_feature});
        }
        return rows;
      });
}

FeatureSet depth(const FeatureView& features, std::span<const std::uint32_t> groups, const Options& options) {
  if (!groups.empty()) check_groups(features, groups);
  const std::size_t source_count =
      groups.empty() ? features.feature_count() : std::size_t{1} + *std::max_element(groups.begin(), groups.end());
  return run(
      {{&features, 1}, false, source_count, KeyRule::count(), {}}, options,
      [&](std::size_t, std::size_t f) { return groups.empty() ? static_cast<std::uint32_t>(f) : groups[f]; },
      to_features);
}

Partition partition(std::span<const FeatureView> layers, const Options& options) {
  Array<std::size_t> first_source;
  std::size_t source_count = 0;
  for (const FeatureView& layer : layers) {
    first_source.push_back(source_count);
    source_count += layer.feature_count();
  }
  return run(
      {layers, false, source_count, KeyRule::set(), {}}, options,
      [&](std::size_t layer, std::size_t f) { return static_cast<std::uint32_t>(first_source[layer] + f); },
      [&](KeyedResult result) {
        Partition rows{{std::move(result.regions), std::move(result.feature_ends), {}}, {}, {}};
        for (std::uint32_t row = 0; row < rows.rows.feature_ends.size(); ++row)
          rows.rows.keys.push_back({row, no_feature});
        rows.source_ends.assign(result.source_ends.begin(), result.source_ends.end());
        rows.sources.reserve(result.sources.size());
        for (const std::uint32_t source : result.sources) {
          const auto it = std::upper_bound(first_source.begin(), first_source.end(), source) - 1;
          rows.sources.push_back(
              {static_cast<std::uint32_t>(it - first_source.begin()), static_cast<std::uint32_t>(source - *it)});
        }
        return rows;
      });
}

}  // namespace oblast
