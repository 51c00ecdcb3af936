// Checks a buffer zone against its definition: how near to the shapes its outline comes, how far it goes, and what is
// inside. It shares no code with src/.
//
//   outline    no point of it is nearer to the shapes than `lower`, or further away than `upper`
//   inside     shapes and everything nearer than `lower` are in the zone; everything further than `upper` is not
//
// If the outline keeps its bounds, all places that are nearer than `lower` and connected with each other are in the
// zone together, or are not. Each such set holds a vertex of the shapes, so testing these vertices proves it for all
// places. Places further than `upper` may lie in holes of the zone that it lacks; these are tested by sample: random
// points, middles of pairs of vertices, and centres of circles through three vertices.
//
// Bounds are decided in doubles with a margin, and in doubt exactly, with rationals.
#pragma once

#include <oblast/point.h>
#include <oblast/region_set.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "verify/verify.h"

namespace oblast::verify {

/// The shapes of a zone. Regions are closed (check_closed). A line is a chain of segments; a point is a segment of two
/// equal ends.
struct ZoneOf {
  RegionView regions;
  struct Segment {
    Point a, b;
  };
  std::vector<Segment> segments;  ///< of lines and points
};

struct ZoneBounds {
  double lower, upper;      ///< distances
  bool check_lower = true;  ///< false: of a zone whose outline may come nearer, as with flat caps
  double slack = 0;         ///< so far shapes may stick out: bevels and flat caps go through their own corners
  bool holds_lines = true;  ///< false: of a zone on one side of its lines
  std::uint32_t samples = 100;
  std::uint64_t seed = 1;
};

/// What was measured, in doubles.
struct ZoneDistances {
  double nearest = 0;   ///< of the outline from the shapes
  double furthest = 0;  ///< of its vertices
};

/// The first fault. Cost: O(n m) for n edges of the zone, m of the shapes.
/// REQUIRES: the zone is closed (check_closed).
std::optional<Fault> check_zone(const RegionView& zone, const ZoneOf& shapes, const ZoneBounds& bounds,
                                ZoneDistances* distances = nullptr);

/// The same for a zone of negative distance: `shapes` has regions only; distances are from their boundary, inwards, and
/// the zone must lie in them.
std::optional<Fault> check_inner_zone(const RegionView& zone, const ZoneOf& shapes, const ZoneBounds& bounds,
                                      ZoneDistances* distances = nullptr);

}  // namespace oblast::verify
