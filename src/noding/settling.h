// Where a round of noding puts a crossing: at a new vertex, or at a vertex that exists already.
#pragma once

#include <oblast/point.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "base/tuning.h"

namespace oblast::internal::noding {

/// How a round of noding settles a crossing.
///
/// The first round puts a new vertex at every crossing, rounded to the nearest double. Where edges run within an
/// ulp of each other, that alone need not end soon: each rounded vertex tilts its edges, the tilted
/// pieces cross their neighbours anew somewhere else, and near 0, where doubles are dense, a crossing can creep
/// towards an axis for thousands of rounds. So from the second round on a crossing that has an end of one edge within
/// `tolerance` of the other is settled there, at a vertex that exists already: no new vertex, so no new tilt. Should
/// even that go on, tolerance and unit of rounding double every round until no new coordinate can appear.
struct Settling {
  double tolerance = 0;  ///< in ulps of the largest coordinate of the two edges; 0: always a new vertex
  int doublings = -1;    ///< new vertices are multiples of that ulp, doubled so often; negative: nearest double

  static Settling of_round(std::uint64_t round) {
    if (round <= tuning::last_nearest_round) return {};
    if (round <= tuning::last_patient_round) return {tuning::settling_ulps, -1};
    const int doublings = static_cast<int>(round - tuning::last_patient_round);
    return {std::ldexp(tuning::settling_ulps, doublings), doublings};
  }
};

/// The new vertex where (a, b) and (c, d) cross, in the boxes of both edges. REQUIRES: they cross inside both.
Point new_vertex(const Settling& settling, const Point& a, const Point& b, const Point& c, const Point& d);

/// How far an end of one edge may be from the other edge so that their crossing is settled at that end. The four ends
/// of both edges, in any order.
double settling_distance(const Settling& settling, const std::array<Point, 4>& ends);

/// Distance of p from the line (a, b), the same bits for (b, a).
double distance_from_line(const Point& p, Point a, Point b);

}  // namespace oblast::internal::noding
