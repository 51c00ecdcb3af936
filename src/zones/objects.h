// Objects: which shapes belong to which, and the room that they and the frame take.
#pragma once

#include <oblast/zones.h>

#include <cstdint>

#include "base/call_memory.h"
#include "plane/box.h"

namespace oblast::internal::zoning {

struct Objects {
  ShapeView shapes;
  Array<std::uint32_t> of_polygon, of_line, of_point;  ///< the object of each shape
  std::uint32_t count = 0;
};

/// Throws Error(bad_option) if the row numbers do not fit the shapes.
Objects read_objects(const ShapeFeatures& features);

/// A coordinate that was computed, as one of the domain: what is nearer to zero than its smallest magnitude is zero.
double in_domain_near(double x);

/// Where everything takes place.
struct Room {
  double tolerance = 0;    ///< epsilon; it is shared out to the next two
  double sampling = 0;     ///< how much further a place may be from its object than from another one, for lack of sites
  double flattening = 0;   ///< how far borders may be moved to save vertices; this counts twice
  double unit = 0;         ///< in the last place of the largest coordinate
  Array<Point> box_frame;  ///< where the caller gave no frame: the corners of the frame
  /// Points that stand for the far outside: so far that no place of the frame, and no object, is nearer to them than to
  /// any object, and on a circle around all, so that every zone is bounded.
  Array<Point> ring;
};

/// Throws Error(bad_option) if it does not fit the domain. REQUIRES: there are shapes.
Room make_room(const ShapeView& shapes, const RegionView& frame, const ZoneOptions& options);

}  // namespace oblast::internal::zoning
