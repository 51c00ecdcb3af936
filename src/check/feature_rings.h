// The rings of one feature to work on: without repeated vertices, each with its first vertex repeated as its last.
#pragma once

#include <oblast/check_features.h>

#include <cstdint>
#include <span>
#include <vector>

#include "base/call_memory.h"

namespace oblast::internal::checking {

/// A feature of a layer, with the ranges that it has in the layer's arrays.
struct FeatureSpan {
  const FeatureView& layer;
  std::uint32_t feature;

  std::uint32_t polygon_begin() const { return layer.feature_begin(feature); }
  std::uint32_t polygon_end() const { return layer.feature_end(feature); }
};

//   points   a0 a1 a2 a0 | b0 b1 b2 b3 b0       edge i runs from points[i] to points[i + 1]
//   ends              4                9
struct FeatureRings {
  Array<Point> points;
  Array<std::uint32_t> vertex;   ///< by point: the vertex in its contour
  Array<std::uint32_t> ends;     ///< by ring
  Array<std::uint32_t> contour;  ///< by ring
  Array<std::uint32_t> polygon;  ///< by ring
  Array<std::uint8_t> is_hole;   ///< by ring
  /// By ring: it crosses, runs along or repeats something, so that it cannot be asked what is inside.
  Array<std::uint8_t> broken;
  std::uint32_t feature = 0;

  std::size_t size() const { return ends.size(); }
  std::uint32_t begin(std::size_t ring) const { return ring == 0 ? 0 : ends[ring - 1]; }
  std::uint32_t ring_of(std::uint32_t index) const;
  /// The vertices before and after a vertex that is not the last of its ring.
  std::uint32_t before(std::uint32_t index, std::uint32_t ring) const {
    return index == begin(ring) ? ends[ring] - 2 : index - 1;
  }
  std::uint32_t after(std::uint32_t index) const { return index + 1; }
  FeaturePlace place(std::uint32_t ring, std::uint32_t index) const { return {feature, contour[ring], vertex[index]}; }
};

/// Keeps the rings of a list, in its order. Cost: linear.
void keep_rings(FeatureRings& rings, std::span<const std::uint32_t> order);

/// Clears `rings` and fills it with the rings of a feature that have three vertices or more; faults and notes of single
/// vertices go to `faults`: too few points, spikes, repeated vertices. A ring that repeats another is left out.
/// Cost: O(n log n) at most, linear for one ring.
void collect_rings(const FeatureSpan& feature, FeatureRings& rings, std::vector<FeatureFault>& faults);

}  // namespace oblast::internal::checking
