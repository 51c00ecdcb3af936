// Systems in which lengths are lengths: for a layer in degrees that is to be measured in metres.
#pragma once

#include <oblast/measure.h>

#include <string>

namespace oblast::io {

/// The unit of the coordinates of a system.
struct CoordinateUnit {
  bool angle = false;    ///< longitude and latitude
  double metres = 0;     ///< length of a unit; 0: an angle, or not known
  double full_turn = 0;  ///< 360 for degrees; 0: no angle
};

/// Of an empty text nothing is known.
CoordinateUnit coordinate_unit(const std::string& wkt);

struct WorkingCrs {
  std::string wkt;
  /// A length on the ellipsoid and the same length there differ at most by about this share of it, within the extent
  /// and the reach.
  double scale_error = 0;
};

/// A projected system on the datum of `geographic_wkt` for a layer with this extent, in its coordinates, and for places
/// up to `reach` metres from it. In metres. If few degrees are enough, it is a UTM zone. If the layer is small beside
/// the reach, it is the azimuthal equidistant projection, else Lambert's azimuthal equal-area, around the middle of the
/// extent, or around a pole. REQUIRES: coordinate_unit(geographic_wkt).angle. Throws IoError if the places are more
/// than a quarter of the globe away from the middle.
WorkingCrs suitable_crs(const std::string& geographic_wkt, const Box& extent, double reach);

}  // namespace oblast::io
