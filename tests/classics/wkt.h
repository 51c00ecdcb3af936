// Regions as text with all digits, for messages of failing cases.
#pragma once

#include <oblast/region_set.h>

#include <cstdio>
#include <string>

namespace oblast::tests {

inline std::string wkt(const RegionView& regions) {
  std::string text = "MULTIPOLYGON (";
  for (std::size_t p = 0; p < regions.polygon_count(); ++p) {
    text += p ? ", (" : "(";
    for (std::uint32_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c) {
      text += c > regions.polygon_begin(p) ? ", (" : "(";
      const auto ring = regions.contour(c);
      for (std::size_t i = 0; i <= ring.size() && !ring.empty(); ++i) {
        char number[80];
        const Point& v = ring[i % ring.size()];
        std::snprintf(number, sizeof number, "%s%.17g %.17g", i ? ", " : "", v.x, v.y);
        text += number;
      }
      text += ")";
    }
    text += ")";
  }
  return text + ")";
}

}  // namespace oblast::tests
