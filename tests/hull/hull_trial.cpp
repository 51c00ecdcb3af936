#include "hull/hull_trial.h"

#include <oblast/hull.h>

#include <algorithm>

#include "exact/orientation.h"
#include "hull/lee.h"
#include "overlay/simple_ring.h"

namespace oblast::tests {

std::string compare_hulls(const std::vector<Point>& ring) {
  std::vector<Point> points = ring;
  const std::vector<Point> expected = monotone_chain_hull(points);
  if (hull(ring) != expected) return "hull() differs from the monotone chain";
  std::vector<Point> clockwise = ring;
  const auto smallest = std::min_element(ring.begin(), ring.end(), lexicographically_less) - ring.begin();
  const std::size_t n = ring.size(), at = static_cast<std::size_t>(smallest);
  if (exact::orientation(ring[(at + n - 1) % n], ring[at], ring[(at + 1) % n]) > 0)
    std::reverse(clockwise.begin(), clockwise.end());
  std::vector<Point> corners = lee_hull(clockwise);
  if (!corners.empty()) std::reverse(corners.begin() + 1, corners.end());
  return corners == expected ? "" : "Lee's scan differs from the monotone chain";
}

bool is_simple(const std::vector<Point>& ring) { return ring_shape(ring) != RingShape::tangled; }

}  // namespace oblast::tests
