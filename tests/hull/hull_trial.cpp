#include "hull/hull_trial.h"

#include <oblast/hull.h>

#include "hull/lee.h"
#include "overlay/simple_ring.h"

namespace oblast::tests {

std::string compare_hulls(const std::vector<Point>& ring) {
  std::vector<Point> points = ring;
  const std::vector<Point> expected = monotone_chain_hull(points);
  if (hull(ring) != expected) return "hull() differs from the monotone chain";
  const int direction = turn_at_smallest(ring);
  if (lee_hull(ring, direction) != expected) return "Lee's scan differs from the monotone chain";
  const std::vector<Point> backward(ring.rbegin(), ring.rend());
  if (lee_hull(backward, -direction) != expected) return "Lee's scan of the reversed ring differs";
  return "";
}

bool is_simple(const std::vector<Point>& ring) { return ring_shape(ring) != RingShape::tangled; }

}  // namespace oblast::tests
