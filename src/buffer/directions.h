// The directions of arcs: one global grid, the same for every arc of every call.
//
//   level 0: 4 directions, along the axes       level j: 4 * 2^j directions, those of level j - 1 and their bisectors
//
// A finer level holds the directions of a coarser one, bit for bit. Bisectors are sums of unit vectors divided by their
// length, so only + * / and sqrt are used (promise G3b).
#pragma once

#include <oblast/point.h>

#include <cstddef>

#include "base/call_memory.h"

namespace oblast::internal::buffering {

inline double cross(const Point& u, const Point& w) { return u.x * w.y - u.y * w.x; }
inline double dot(const Point& u, const Point& w) { return u.x * w.x + u.y * w.y; }

class Directions {
 public:
  static constexpr int most_levels = 18;

  /// The first level, from 1 on, at which half the angle between neighbours has a cosine of at least `cosine`.
  static int level_for(double cosine);

  /// The cosine of half the angle between neighbours of so many directions.
  static double cosine_of(std::size_t count);

  explicit Directions(int level);  ///< REQUIRES: level >= 1

  std::size_t count() const { return 4 * quarter_; }
  /// Direction k modulo count(), as a unit vector.
  Point operator[](std::size_t k) const;

  /// Those strictly between two unit vectors, counter-clockwise.
  struct Range {
    std::size_t first;
    std::size_t count;
  };
  /// REQUIRES: from `from` to `to` is at most half a turn, counter-clockwise.
  Range between(const Point& from, const Point& to) const;

 private:
  std::size_t first_after(const Point& u) const;
  std::size_t last_before(const Point& u) const;

  std::size_t quarter_;          ///< directions in a quadrant
  Array<Point> first_quadrant_;  ///< quarter_ + 1 directions, from (1, 0) to (0, 1)
};

}  // namespace oblast::internal::buffering
