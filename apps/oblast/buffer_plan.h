// What `oblast buffer` is told, read before any file, and the system in which it computes.
#pragma once

#include <string>

#include "io/rows.h"
#include "oblast/buffer_distance.h"

namespace oblast::app {

struct BufferPlan {
  Distance distance;
  Tolerance tolerance;
  std::string crs;  ///< WKT, "auto" or empty
};

/// `crs` is a word for a projected system, "auto" or empty. Throws CallError.
BufferPlan buffer_plan(const std::string& distance, const std::string& tolerance, const std::string& crs);

struct PlaneChoice {
  std::string crs_wkt;  ///< empty: the system of the layer
  std::string note;     ///< for the user; may be empty
};

/// The system to compute in. Throws CallError where lengths cannot be measured, with what to do; IoError as
/// io::suitable_crs and `distances`.
PlaneChoice choose_plane(const BufferPlan& plan, const io::Rows& rows);

}  // namespace oblast::app
