#include "repair/size_bounds.h"

#include <cmath>

namespace oblast::internal::repairing {
namespace {

bool is_area_below(double bound, const ExactSum& twice_area) {
  if (bound == 0) return false;
  if (std::isinf(bound)) return true;
  ExactSum difference = twice_area;
  difference.add(-bound);  // twice
  difference.add(-bound);
  return difference.sign() < 0;
}

double perimeter(const RegionView& piece) {
  double sum = 0;
  for (std::size_t c = 0; c < piece.contour_count(); ++c) {
    const std::span<const Point> ring = piece.contour(c);
    for (std::size_t i = 0; i < ring.size(); ++i) sum += edge_length(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
  }
  return sum;
}

}  // namespace

double edge_length(const Point& p, const Point& q) {
  const double dx = q.x - p.x, dy = q.y - p.y;
  return std::sqrt(dx * dx + dy * dy);
}

bool is_below(const SizeBounds& bounds, const RegionView& piece, const ExactSum& twice_area) {
  if (is_area_below(bounds.area, twice_area)) return true;
  if (bounds.width == 0) return false;
  return std::isinf(bounds.width) || twice_area.estimate() < bounds.width * perimeter(piece);
}

}  // namespace oblast::internal::repairing
