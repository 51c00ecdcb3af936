#include "hull/hull_trial.h"

#include <oblast/hull.h>

#include <algorithm>

#include "hull/lee.h"
#include "noding/simple_ring.h"

namespace oblast::tests {
using namespace internal;

std::vector<Point> chain_hull(const std::vector<Point>& points) {
  Array<Point> sorted(points.begin(), points.end());
  const Array<Point> hull = monotone_chain_hull(sorted);
  return {hull.begin(), hull.end()};
}

std::string compare_hulls(const std::vector<Point>& ring) {
  const std::vector<Point> expected = chain_hull(ring);
  if (hull(ring) != expected) return "hull() differs from the monotone chain";
  const int direction = turn_at_smallest(ring);
  if (!std::ranges::equal(lee_hull(ring, direction), expected)) return "Lee's scan differs from the monotone chain";
  const std::vector<Point> backward(ring.rbegin(), ring.rend());
  if (!std::ranges::equal(lee_hull(backward, -direction), expected)) return "Lee's scan of the reversed ring differs";
  return "";
}

bool is_simple(const std::vector<Point>& ring) { return ring_shape(ring) != RingShape::tangled; }

}  // namespace oblast::tests
