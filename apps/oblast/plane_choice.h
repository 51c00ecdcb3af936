// In which coordinate system lengths are measured: that of the layer, or a projected one for a layer in degrees.
#pragma once

#include <oblast/measure.h>

#include <string>

#include "io/layer.h"

namespace oblast::app {

/// The WKT of the system that --crs names, "auto", or empty. Throws CallError if it is none, or is not projected.
std::string parse_plane(const std::string& word);

/// What a command wants to measure, and where.
struct PlaneQuery {
  std::string crs;          ///< from parse_plane
  Box extent;               ///< of all shapes, in the coordinates of the layer
  double reach = 0;         ///< places up to so many metres from them matter
  bool in_degrees = false;  ///< the user gave a length in degrees
  const char* what;         ///< "a distance needs": who needs a projected system
  const char* example;      ///< "--distance \"0.1 degrees\"": what to write if degrees are meant
};

struct PlaneChoice {
  std::string crs_wkt;  ///< empty: the system of the layer
  std::string note;     ///< for the user; may be empty
};

/// Throws CallError where lengths cannot be measured, with what to do; IoError as io::suitable_crs.
PlaneChoice choose_plane(const io::Layer& layer, const PlaneQuery& query);

/// What --crs does, for help.
inline constexpr const char* plane_help =
    "compute in this projected coordinate system and come back: EPSG:N, or `auto` for one that fits";

}  // namespace oblast::app
