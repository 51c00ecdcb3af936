// A walker who knows where he is, and can go back the way he came.
#pragma once

#include <span>
#include <vector>

#include "verify/membership.h"

namespace oblast::verify {

/// He starts outside of everything.
class Walker {
 public:
  Walker(const Segments& segments, const Membership& outside) : segments_(segments), here_(outside) {}

  /// What is inside where he stands.
  const Membership& here() const { return here_; }

  /// From q' to r' (side_of, verify/segments.h) by way of (r.x, q.y): to the side, then up or down. Returns how many
  /// steps over edges he had made before. REQUIRES: he stands at q'; `edges` are all that come to the way, maybe more.
  std::size_t walk(const Point& q, const Point& r, std::span<const std::uint32_t> edges);

  /// Back the way he came, until he has made so many steps.
  void take_back(std::size_t steps);

 private:
  struct Step {
    std::uint32_t edge;
    int side;
  };
  void cross(std::uint32_t edge, int side_before, int side_after);

  const Segments& segments_;
  Membership here_;
  std::vector<Step> steps_;
};

}  // namespace oblast::verify
