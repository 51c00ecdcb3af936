// The zones of a real layer, judged by verify/zones.h.
#pragma once

#include <cstdint>
#include <string>

namespace oblast::testing {

struct LayerTrial {
  double relative_tolerance = 1e-5;
  std::uint64_t places =
      10'000;  ///< whose nearest object is tested: so many uniform ones, so many on and beside borders
  std::uint64_t seed = 1;
};

/// Lengths are in the units of the layer's coordinates.
struct LayerFigures {
  std::uint64_t objects = 0, vertices = 0, sites = 0;
  double tolerance = 0;  ///< epsilon as asked for
  double error = 0;      ///< epsilon as proved by the library (ZoneStatistics::error)
  double rounding = 0;   ///< C
  double seen = 0;       ///< the largest epsilon of all places that were tested
  std::uint64_t places = 0;
  std::uint64_t exactly = 0;  ///< so many of the places by rational numbers
  std::uint64_t excused = 0;  ///< pieces and places beside slivers that moved edges left
  std::string fault;          ///< the first broken promise; empty: Z1, Z2 and Z3 hold
};

/// Reads a layer (FILE, or FILE:LAYER), makes the zone of each of its features in the box of all with a margin of a
/// tenth, in the plane of its coordinates, and tests Z1, Z2 and Z3. Throws io::IoError and Error.
LayerFigures judge_layer(const std::string& path, const LayerTrial& trial);

}  // namespace oblast::testing
