#include "hull/sklansky.h"

#include <algorithm>

#include "exact/orientation.h"

namespace oblast::tests {
using namespace internal;

// From a vertex known to be a corner, go round; wherever the last three vertices do not turn left, drop the middle one
// and look at the one before again.
std::vector<Point> sklansky_scan(std::vector<Point> ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), lexicographically_less), ring.end());
  ring.push_back(ring.front());
  std::vector<Point> corners;
  for (const Point& p : ring) {
    while (corners.size() > 1 && exact::orientation(corners[corners.size() - 2], corners.back(), p) <= 0)
      corners.pop_back();
    corners.push_back(p);
  }
  corners.pop_back();
  return corners;
}

}  // namespace oblast::tests
