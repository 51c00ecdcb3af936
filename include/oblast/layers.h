// Layers: overlapping contours dealt to groups within which none overlap.
#pragma once

#include <oblast/error.h>
#include <oblast/export.h>
#include <oblast/options.h>
#include <oblast/region_set.h>

#include <cstdint>
#include <vector>

namespace oblast {

/// Which contours may not be in one layer. Contours that only touch, or share borders from either side, may.
enum class LayerRule {
  /// Those whose interiors have a point in common, decided exactly. A contour that meets itself has no plain
  /// interior: it is kept apart from every contour whose box overlaps its own.
  interiors,
  /// Those whose bounding boxes overlap, as the 2013 paper projects them on its raster: quicker, more layers.
  boxes,
};

struct Layers {
  std::vector<std::uint32_t> layer;  ///< by contour of the input: its layer, from 0
  std::uint32_t count = 0;           ///< layers are 0 to count - 1

  friend bool operator==(const Layers&, const Layers&) = default;
};

/// Deals the contours, in the order of the input, each to the first layer where nothing overlaps it (the paper:
/// "Overlays of vector data with a large number of simple contours", GraphiCon 2013, section 4.3). Polygons are
/// not looked at: a hole is a contour inside another. Contours without an interior are in layer 0.
/// Cost: O((n + v) log n + p), n contours, v vertices, p pairs whose boxes overlap, besides the edges of
/// a pair whose boxes meet; memory O(n + v).
/// Throws Error: not_finite, out_of_domain, too_large, bad_offsets, bad_option, cancelled, memory_limit.
OBLAST_API Layers layers(const RegionView& operand, LayerRule rule = LayerRule::interiors,
                         const CallOptions& options = {});

}  // namespace oblast
