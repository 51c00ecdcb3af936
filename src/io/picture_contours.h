// Contours as SVG paths of bounded size.
#pragma once

#include <oblast/region_set.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "io/picture_frame.h"

namespace oblast::io {

/// One view, drawn in one panel. Paths are in tenths of a pixel.
struct DrawnContours {
  std::string polygons;  ///< `<path .../>` for each polygon (each even-odd of its own contours)
  std::string outlines;  ///< the same contours as the data of one path
  /// `<path .../>` elements: squares where contours below a pixel lie, the more opaque the more of them they cover.
  std::string dots;
  std::uint64_t drawn = 0;     ///< contours drawn as they are
  std::uint64_t gathered = 0;  ///< contours shown as dots
  std::uint64_t left_out = 0;  ///< contours that would have made the picture too large
};

/// Which texts are wanted: fills for operands, outlines for results.
enum class DrawAs { polygons, outlines };

/// Draws the part of the view that lies in the frame. `dot` is the side of a dot, in pixels. All texts together have
/// about `most_bytes` bytes at most: the lattice to which vertices are snapped is made coarser until this holds.
DrawnContours draw_contours(const RegionView& view, const Frame& frame, DrawAs as, double dot,
                            std::size_t most_bytes = 700'000);

}  // namespace oblast::io
