// What pieces look like, and how far they reach: worked out once a call from the distance and the options.
//
// Bounds. With f the relative tolerance, an arc has its vertices at the distance `reach` from its corner, and its
// chords come as near as `reach` times the cosine of half the angle between two directions of the grid:
//
//   mode      vertices at              chords not nearer than           so the cosine must be at least
//   nearest   at most (1 + f) d        (1 + f) d cos                    (1 - f) / (1 + f)
//   inside    d                        d cos                            1 - f / 2, for lids have the rest
//   outside   at most d / cos          d (they are tangents)            1 / (1 + f)
//
// A lid of length w is offset by d, so the outline beside its middle is at most sqrt(d^2 + w^2 / 4) from the input. In
// mode inside the pieces at its ends reach sqrt(d^2 - w^2 / 4): beside its middle, the discs around its ends reach as
// far. The chords of their arcs are nearer by the cosine, so both together are kept above (1 - f) d.
#pragma once

#include <oblast/buffer.h>

#include "buffer/directions.h"

namespace oblast::internal::buffering {

struct ZoneShape {
  /// REQUIRES: distance > 0.
  ZoneShape(double distance, const BufferOptions& options);

  Join join;
  Cap cap;
  BufferMode mode;
  double distance;         ///< of the call
  double mitre_limit;      ///< times the distance
  double reach;            ///< of arcs, times the distance
  double straight_cosine;  ///< a corner whose normals have at least this dot product needs no arc
  double widest_lid = 0;   ///< 0: no pocket is closed
  double furthest;         ///< the zone reaches at most so far, times the distance
  double lower_factor, upper_factor;
  Directions directions;

  /// The distance of pieces at a vertex: that of the call, moved by what rounding may do to its edges. `largest`: the
  /// largest coordinate of the vertex and of the other ends of its edges. Nothing else counts, so nothing that lies
  /// elsewhere changes a zone (promise G7).
  double distance_at(double largest) const;
  /// True if an edge from p to q is too short for a piece.
  bool is_near(const Point& p, const Point& q) const;

  /// The distance at an end of a lid of this length, which without the lid is `distance`.
  double lid_distance(double distance, double length) const;

  /// BufferStatistics::rounding, for shapes with this largest coordinate. Throws Error(bad_option) if the zone leaves
  /// the domain.
  double rounding(double largest_coordinate) const;
};

}  // namespace oblast::internal::buffering
