// What `oblast buffer` is told, read before any file, and the system in which it computes.
#pragma once

#include <string>

#include "io/rows.h"
#include "oblast/buffer_distance.h"
#include "oblast/plane_choice.h"

namespace oblast::app {

struct BufferPlan {
  Distance distance;
  Tolerance tolerance;
  std::string crs;  ///< WKT, "auto" or empty
};

/// `crs` is a word for a projected system, "auto" or empty. Throws CallError.
BufferPlan buffer_plan(const std::string& distance, const std::string& tolerance, const std::string& crs);

/// The system to compute in. Throws as choose_plane(layer, query) and `distances`.
PlaneChoice choose_plane(const BufferPlan& plan, const io::Rows& rows);

}  // namespace oblast::app
