// Tests each edge once.
#include "verify/surroundings.h"

#include <algorithm>

namespace oblast::verify {

Surroundings look_around(const Segments& segments, const Point& p, std::span<const std::uint32_t> edges, double bound,
                         bool with_distance) {
  Surroundings around;
  for (const std::uint32_t e : edges) {
    const Segment& s = segments[e];
    if (s.owner == EdgeOf::result) {
      around.on_the_result = around.on_the_result || lies_on(s, p);
      continue;
    }
    if (!may_be_near(s, p, bound)) continue;
    around.near_an_edge = true;
    if (spans_height_of(s, p)) (s.owner == EdgeOf::a ? around.of_a : around.of_b).push_back({&s, side_of(s, p)});
    if (with_distance) around.distance = std::min(around.distance, distance_in_box(s, p));
  }
  return around;
}

}  // namespace oblast::verify
