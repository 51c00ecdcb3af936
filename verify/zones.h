// Checks proximity zones against their promises. It shares no code with src/.
//
//   check_zone_cover       Z1, Z2: rows are a coverage of the frame, and every object is in its own row
//   check_zone_distances   Z3: from no place of a row another object is nearer by more than epsilon
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "verify/verify.h"
#include "verify/zone_objects.h"

namespace oblast::verify {

/// Zones to be judged. `frame`: polygons, each the even-odd of its rings; the frame is their union.
struct JudgedZones {
  const ZoneObjects& objects;
  RegionView frame;
  FeatureView rows;
  std::span<const FeatureKey> keys;  ///< of the rows: keys[r].a is an object
};

struct ZoneCoverBounds {
  /// Where edges of objects and of the frame cross at places that are no doubles, or come nearer to each other than
  /// this, pieces of them may have moved so far.
  double moved = 0;
  bool is_whole = true;  ///< false: zones end at a largest distance, so places may be in no row
};

struct ZoneCoverMeasures {
  std::uint64_t pieces = 0;
  std::uint64_t excused = 0;  ///< pieces beside slivers that moved edges left
};

/// Proves of rows, exactly:
/// - they are canonical, and their edges meet at common ends only (check_rows); keys ascend;
/// - every place of the frame is in one row, or at most one if not `is_whole`, and places out of the frame are in none;
/// - a place in the regions of objects is in the row of the lowest of them;
/// - a place of a line is in the closed row of its object; if other lines overlap it, of the lowest of their
///   objects; if it is in regions, in the row of one of them;
/// - a point is in the closed row of its object; if others are equal, of the lowest of their objects; if it is on lines
///   or in regions, in the row of one of them.
/// All edges of rows, objects and frame are cut where they meet, and both sides of every piece are tested. Every face
/// of this arrangement has such a side, so nothing is left out. Cost: O((n + k) log n) for n edges with k meetings, if
/// rows and polygons do not nest deeply.
std::optional<Fault> check_zone_cover(const JudgedZones& zones, const ZoneCoverBounds& bounds,
                                      ZoneCoverMeasures* measures = nullptr);

struct ZoneDistanceBounds {
  double epsilon = 0;  ///< Z3
  /// With a largest distance: places nearer than `lower` are in a row, and no place of a row is further than `upper`.
  double lower = std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
  double thin = 0;              ///< parts of regions that are thinner may be gone, since rounding may close them
  std::uint64_t places = 1000;  ///< so many in the frame, and so many on and beside borders
  std::uint64_t seed = 1;
};

struct ZoneDistanceMeasures {
  double epsilon = 0;         ///< the largest d(x, own object) - min d(x, other object), up to rounding
  std::uint64_t places = 0;   ///< so many were tested, once for every row that holds them
  std::uint64_t exactly = 0;  ///< so many of them by rational numbers
};

/// Tests places x in the frame, at vertices of rows, on edges of rows and a few units in the last place beside: for
/// each closed row of an object i that holds x, and every other object j, d(x, i) <= d(x, j) + epsilon. Distances are
/// compared exactly. REQUIRES: check_zone_cover found no fault. Cost: O(log n) for a place.
std::optional<Fault> check_zone_distances(const JudgedZones& zones, const ZoneDistanceBounds& bounds,
                                          ZoneDistanceMeasures* measures = nullptr);

/// The unit in the last place of the largest coordinate.
double zone_unit(const JudgedZones& zones);

}  // namespace oblast::verify
