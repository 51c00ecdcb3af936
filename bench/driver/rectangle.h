// Peers that clip by an axis-parallel rectangle only.
#pragma once

#include <algorithm>

#include "driver/driver.h"

namespace oblast::bench {

struct Rectangle {
  double x0, y0, x1, y1;
};

/// B as a rectangle. Throws Unsupported if B is not a rectangle, or if the operation is not the intersection.
inline Rectangle clip_rectangle(const Settings& settings, const RegionView& b) {
  if (settings.operation != Operation::intersection || b.contour_count() != 1 || b.points.size() != 4)
    throw Unsupported("only for clipping by a rectangle");
  Rectangle r{b.points[0].x, b.points[0].y, b.points[0].x, b.points[0].y};
  for (const Point& p : b.points) {
    r = {std::min(r.x0, p.x), std::min(r.y0, p.y), std::max(r.x1, p.x), std::max(r.y1, p.y)};
  }
  for (const Point& p : b.points) {
    if ((p.x != r.x0 && p.x != r.x1) || (p.y != r.y0 && p.y != r.y1))
      throw Unsupported("only for clipping by a rectangle");
  }
  return r;
}

}  // namespace oblast::bench
