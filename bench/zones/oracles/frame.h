// The frame of all comparisons: the box of the shapes with a margin of a tenth of its larger side.
#pragma once

#include <algorithm>

#include "buffers/shape_file.h"

namespace zones {

struct FrameBox {
  double x0 = 1e300, y0 = 1e300, x1 = -1e300, y1 = -1e300;

  explicit FrameBox(const buffers::Shapes& shapes) {
    for (const auto* points : {&shapes.region_points, &shapes.line_points, &shapes.points})
      for (const auto& p : *points)
        x0 = std::min(x0, p.x), y0 = std::min(y0, p.y), x1 = std::max(x1, p.x), y1 = std::max(y1, p.y);
    const double margin = std::max(x1 - x0, y1 - y0) / 10;
    x0 -= margin, y0 -= margin, x1 += margin, y1 += margin;
  }
  bool has_inside(double x, double y) const { return x0 < x && x < x1 && y0 < y && y < y1; }
};

}  // namespace zones
