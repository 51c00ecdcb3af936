// Calls the library, and computes the digests of the results. An error is a result, too: its code.
#include "golden/results.h"

#include <oblast/error.h>
#include <oblast/hull.h>
#include <oblast/layers.h>
#include <oblast/overlay.h>
#include <oblast/triangulate.h>

#include <bit>
#include <cstdint>
#include <vector>

namespace oblast::golden {
namespace {

void add(Digest& digest, const FillRule& rule) {
  digest.add(static_cast<std::uint64_t>(rule.kind));
  digest.add(static_cast<std::uint64_t>(rule.depth));
}

void add(Digest& digest, const Options& options) {
  add(digest, options.fill_a);
  add(digest, options.fill_b);
  digest.add(static_cast<std::uint64_t>(options.contours));
  digest.add(static_cast<std::uint64_t>(options.collinear));
}

void add(Digest& digest, double number) { digest.add(std::bit_cast<std::uint64_t>(number)); }

void add(Digest& digest, const ShapeView& shapes) {
  digest.add(shapes.regions);
  digest.add(RegionView{shapes.lines.points, shapes.lines.line_ends, {}});
  digest.add(shapes.points);
}

void add(Digest& digest, const FeatureSet& features) {
  digest.add(features.regions);
  digest.add(std::span(features.feature_ends));
  for (const FeatureKey& key : features.keys) {
    digest.add(std::uint64_t{key.a});
    digest.add(std::uint64_t{key.b});
  }
}

void add(Digest& digest, const Partition& partition) {
  add(digest, partition.rows);
  digest.add(std::span(partition.source_ends));
  for (const FeatureSource& source : partition.sources) {
    digest.add(std::uint64_t{source.layer});
    digest.add(std::uint64_t{source.feature});
  }
}

void add(Digest& digest, const Triangulation& mesh) {
  digest.add(mesh.regions);
  digest.add(std::span(mesh.points));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    digest.add(mesh.triangles[t]);
    digest.add(mesh.neighbours[t]);
    for (const bool is_side : mesh.is_side[t]) digest.add(std::uint64_t{is_side});
    digest.add(std::uint64_t{mesh.polygon[t]});
  }
}

/// Calls `compute`, which adds its result to the digest.
template <class Compute>
void attempt(Digest& digest, const Compute& compute) {
  try {
    compute();
  } catch (const Error& error) {
    digest.add(~static_cast<std::uint64_t>(error.code()));
  }
}

}  // namespace

InputAndResult four_operations(const RegionView& a, const RegionView& b, const Options& options) {
  Digest input, result;
  input.add(a);
  input.add(b);
  add(input, options);
  for (const Operation operation :
       {Operation::intersection, Operation::unite, Operation::difference, Operation::symmetric_difference})
    attempt(result, [&] { result.add(overlay(a, b, operation, options)); });
  return {input.value(), result.value()};
}

InputAndResult folded(std::span<const RegionSet> operands, Operation operation, const Options& options) {
  Digest input, result;
  for (const RegionSet& operand : operands) input.add(operand);
  add(input, options);
  input.add(static_cast<std::uint64_t>(operation));
  attempt(result, [&] {
    RegionSet sum = unite(operands.front(), options);
    for (const RegionSet& operand : operands.subspan(1)) sum = overlay(sum, operand, operation, options);
    result.add(sum);
  });
  return {input.value(), result.value()};
}

InputAndResult unions(const RegionView& a, std::initializer_list<FillRule> rules) {
  Digest input, result;
  input.add(a);
  for (const FillRule& rule : rules) {
    Options options;
    options.fill_a = rule;
    add(input, rule);
    attempt(result, [&] { result.add(unite(a, options)); });
  }
  return {input.value(), result.value()};
}

InputAndResult hull_layers_triangulation(const RegionView& a) {
  Digest input, result;
  input.add(a);
  attempt(result, [&] { result.add(hull(a)); });
  for (const LayerRule rule : {LayerRule::interiors, LayerRule::boxes})
    attempt(result, [&] { result.add(layers(a, rule).layer); });
  attempt(result, [&] { add(result, triangulate(a)); });
  return {input.value(), result.value()};
}

InputAndResult rows(const RegionView& a, const RegionView& b, const Options& options) {
  Digest input, result;
  input.add(a);
  input.add(b);
  add(input, options);
  constexpr std::uint32_t groups_count = 5;
  std::vector<std::uint32_t> groups;
  for (std::size_t p = 0; p < a.polygon_count(); ++p) groups.push_back(static_cast<std::uint32_t>(p) % groups_count);
  const FeatureView layers[] = {{a, {}}, {b, {}}};
  for (const FeatureOperation operation : {FeatureOperation::identity, FeatureOperation::unite})
    attempt(result, [&] { add(result, overlay_features(layers[0], layers[1], operation, options)); });
  attempt(result, [&] { add(result, dissolve(layers[0], groups, options)); });
  attempt(result, [&] { add(result, depth(layers[0], groups, options)); });
  attempt(result, [&] { add(result, partition(layers, options)); });
  return {input.value(), result.value()};
}

InputAndResult buffer_zone(const ShapeView& shapes, double distance, const BufferOptions& options) {
  Digest input, result;
  add(input, shapes);
  add(input, distance);
  for (const int choice : {static_cast<int>(options.join), static_cast<int>(options.cap),
                           static_cast<int>(options.side), static_cast<int>(options.mode)})
    input.add(static_cast<std::uint64_t>(choice));
  add(input, options.tolerance);
  attempt(result, [&] { result.add(buffer(shapes, distance, options)); });
  return {input.value(), result.value()};
}

InputAndResult proximity_zones(const ShapeView& shapes, const ZoneOptions& options) {
  Digest input, result;
  add(input, shapes);
  add(input, options.relative_tolerance);
  add(input, options.distance);
  attempt(result, [&] { add(result, zones({shapes, {}, {}, {}}, {}, options)); });
  return {input.value(), result.value()};
}

}  // namespace oblast::golden
