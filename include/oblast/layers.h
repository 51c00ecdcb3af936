// Layers: divides contours into groups so that no two contours of a group overlap.
#pragma once

#include <oblast/error.h>
#include <oblast/export.h>
#include <oblast/options.h>
#include <oblast/region_set.h>

#include <cstdint>
#include <vector>

namespace oblast {

/// Which contours must be in different layers. Contours that only touch, or share a border from opposite sides, may be
/// in one layer.
enum class LayerRule {
  /// Contours whose interiors have a point in common, decided exactly. If a contour meets itself, its interior is not
  /// well defined; it is separated from every contour whose bounding box overlaps its own.
  interiors,
  /// Contours whose bounding boxes overlap, as on the raster of the 2013 paper. This is faster, but makes more layers.
  boxes,
};

struct Layers {
  std::vector<std::uint32_t> layer;  ///< for each contour of the input: its layer, from 0
  std::uint32_t count = 0;           ///< layers are 0 to count - 1

  friend bool operator==(const Layers&, const Layers&) = default;
};

/// Puts each contour, in the order of the input, into the first layer in which nothing overlaps it ("Overlays of vector
/// data with a large number of simple contours", GraphiCon 2013, section 4.3). Polygons do not matter: a hole is a
/// contour inside another one. A contour without an interior goes into layer 0.
/// Cost: O((n + v) log n + p) time for n contours with v vertices and p pairs whose boxes overlap, plus the comparison
/// of edges of these pairs (with LayerRule::interiors). Memory: O(n + v).
/// Throws Error: not_finite, out_of_domain, too_large, bad_offsets, bad_option, cancelled, memory_limit.
OBLAST_API Layers layers(const RegionView& operand, LayerRule rule = LayerRule::interiors,
                         const CallOptions& options = {});

}  // namespace oblast
