// Distances in doubles: within a few units in the last place of the coordinates, the same on every machine.
#pragma once

#include <oblast/point.h>

#include <algorithm>
#include <cmath>

namespace oblast::internal::zoning {

inline double distance(const Point& p, const Point& q) {
  const double x = q.x - p.x, y = q.y - p.y;
  return std::sqrt(x * x + y * y);
}

inline double distance_from_segment(const Point& p, const Point& a, const Point& b) {
  const double x = b.x - a.x, y = b.y - a.y;
  const double length = x * x + y * y;
  const double along = (p.x - a.x) * x + (p.y - a.y) * y;
  if (!(along > 0)) return distance(p, a);
  if (!(along < length)) return distance(p, b);
  return std::fabs((p.x - a.x) * y - (p.y - a.y) * x) / std::sqrt(length);
}

}  // namespace oblast::internal::zoning
