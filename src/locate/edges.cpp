#include "locate/edges.h"

#include "base/index.h"

namespace oblast::internal::locate {

Edges edges_of(const RegionView& regions) {
  const std::size_t most = regions.points.size() + regions.contour_count();
  check_count(most, "points of closed contours");
  Edges result;
  result.points.reserve(most);
  result.edges.reserve(regions.points.size());
  for (const std::span<const Point> contour : regions.contours()) {
    const auto add = [&](const Point& p, std::size_t first) {
      if (result.points.size() > first) {
        if (result.points.back() == p) return;
        result.edges.push_back(static_cast<Index>(result.points.size() - 1));
      }
      result.points.push_back({p.x + 0.0, p.y + 0.0});  // -0.0 becomes 0.0
    };
    const std::size_t first = result.points.size();
    for (const Point& p : contour) add(p, first);
    if (!contour.empty()) add(contour.front(), first);
  }
  return result;
}

}  // namespace oblast::internal::locate
