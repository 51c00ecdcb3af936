#include "check/strands_of.h"

#include "base/index.h"
#include "base/large_pages.h"
#include "base/parallel.h"

namespace oblast::internal::checking {

noding::Strands strands_of(const RegionView& regions) {
  const std::size_t contours = regions.contour_count(), vertices = regions.points.size() + contours;
  check_count(vertices, "vertices of strands");
  noding::Strands strands;
  resize_uninitialized(strands.points, vertices);
  strands.resize(vertices, contours);
  strands.flags.assign(vertices, 0);
  for_ranges(contours, grain(contours, vertices), [&](std::size_t c, std::size_t end) {
    for (; c < end; ++c) {
      const std::span<const Point> contour = regions.contour(c);
      const std::size_t begin = regions.contour_begin(c) + c;
      Point* const points = strands.points.data() + begin;
      for (std::size_t v = 0; v < contour.size(); ++v) points[v] = {contour[v].x + 0.0, contour[v].y + 0.0};
      points[contour.size()] = points[0];
      strands.flags[begin] = strands.flags[begin + contour.size()] = noding::closed_flag;
      strands.ends[c] = static_cast<std::uint32_t>(begin + contour.size() + 1);
      strands.change[c] = {1, 0};
      strands.group[c] = noding::any_group;
      strands.simplicity[c] = noding::Simplicity::known;
    }
  });
  return strands;
}

}  // namespace oblast::internal::checking
