#include "buffer/zone_shape.h"

#include <oblast/domain.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "plane/largest_ulp.h"

namespace oblast::internal::buffering {
namespace {

constexpr double least_tolerance = 1e-9, most_tolerance = 0.5;

double relative_tolerance(double distance, const BufferOptions& options) {
  if (!(options.absolute_tolerance > 0)) return options.tolerance;
  return std::clamp(options.absolute_tolerance / distance, least_tolerance, most_tolerance);
}

double arc_cosine(double tolerance, BufferMode mode) {
  switch (mode) {
    case BufferMode::nearest:
      return (1 - tolerance) / (1 + tolerance);
    case BufferMode::inside:
      return 1 - tolerance / 2;  // the other half is for lids
    default:
      return 1 / (1 + tolerance);
  }
}

/// How far the zone reaches at most, as a multiple of the distance.
double furthest_factor(const BufferOptions& options) {
  constexpr double square = 1.5;  // arcs: at most 1 + most_tolerance; corners of square caps: sqrt(2)
  return options.join == Join::mitre ? std::max(square, 2 * options.mitre_limit) : square;
}

}  // namespace

ZoneShape::ZoneShape(double asked, const BufferOptions& options)
    : join(options.join),
      cap(options.cap),
      mode(options.mode),
      distance(asked),
      mitre_limit(options.mitre_limit),
      furthest(furthest_factor(options)),
      directions(Directions::level_for(arc_cosine(relative_tolerance(asked, options), options.mode))) {
  const double tolerance = relative_tolerance(asked, options);
  reach = mode == BufferMode::nearest ? 1 + tolerance : 1;
  // The chord between two normals at an angle a has the distance cos(a / 2); 2 cos^2(a / 2) = 1 + cos(a).
  straight_cosine = mode == BufferMode::nearest ? 2 * (1 - tolerance) * (1 - tolerance) - 1 : 1;
  lower_factor = mode == BufferMode::outside ? 1 : 1 - tolerance;
  upper_factor = mode == BufferMode::inside ? 1 : 1 + tolerance;
  if (join == Join::round) {
    double half_lid_2 = tolerance * (2 + tolerance);
    if (mode == BufferMode::inside) {
      const double part = (1 - tolerance) / Directions::cosine_of(directions.count());
      half_lid_2 = std::max(0.0, 1 - part * part) / 2;  // two lids can meet at a corner, so each takes half
    }
    widest_lid = 2 * distance * std::sqrt(half_lid_2);
  }
}

// Rounding. E = 12 units in the last place of the largest coordinate of an edge bounds what moves its side: a unit
// normal and its multiple are off by at most 5 * 2^-53 of the distance, which is at most 5 units; the sum with the
// corner by half a unit in each coordinate; a vertex that is left out was within 4 units of another one; noding moves
// edges by at most 2 units (docs/guarantees.md). Distances below 2 E are widened to 2 E, so that the zone holds the
// shapes whatever noding moves; the modes inside and outside keep clear of the distance by E. So C = 48 units bound
// everything.
constexpr double moving_units = 12, left_out_units = 4, rounding_units = 48;

double ZoneShape::distance_at(double largest) const {
  const double moves = moving_units * ulp_of(largest + distance * furthest);
  if (mode == BufferMode::nearest) return std::max(distance, 2 * moves);
  if (mode == BufferMode::inside) return std::max(distance - moves, 2 * moves);
  return std::max(distance, moves) + moves;
}

bool ZoneShape::is_near(const Point& p, const Point& q) const {
  const double near = left_out_units * ulp_of(std::max(std::fabs(p.x), std::fabs(p.y)) + distance * furthest);
  const double dx = q.x - p.x, dy = q.y - p.y;
  return dx * dx + dy * dy <= near * near;
}

double ZoneShape::lid_distance(double full, double length) const {
  return mode == BufferMode::inside ? std::sqrt(full * full - length * length / 4) : full;
}

double ZoneShape::rounding(double largest_coordinate) const {
  const double reached = largest_coordinate + distance * furthest;
  if (!(reached <= domain_largest))
    throw Error(ErrorCode::bad_option, "a buffer by " + std::to_string(distance) + " leaves the domain of coordinates");
  return rounding_units * ulp_of(reached);
}

}  // namespace oblast::internal::buffering
