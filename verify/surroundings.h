// The edges within the bound of a point.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "verify/membership.h"

namespace oblast::verify {

struct Surroundings {
  std::vector<UncertainEdge> of_a, of_b;
  bool near_an_edge = false;   ///< an input edge is within the bound, whether its side is uncertain or not
  bool on_the_result = false;  ///< on an edge of the result
  double distance =
      std::numeric_limits<double>::infinity();  ///< to the nearest input edge within the bound, if asked for
};

/// REQUIRES: `edges` has at least all edges within the bound of p.
Surroundings look_around(const Segments& segments, const Point& p, std::span<const std::uint32_t> edges, double bound,
                         bool with_distance);

}  // namespace oblast::verify
