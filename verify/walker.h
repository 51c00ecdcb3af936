// A walker that stores where it is, and can undo its steps.
#pragma once

#include <span>
#include <vector>

#include "verify/membership.h"

namespace oblast::verify {

/// Starts outside of everything.
class Walker {
 public:
  Walker(const Segments& segments, const Membership& outside) : segments_(segments), here_(outside) {}

  /// The membership of its position.
  const Membership& here() const { return here_; }

  /// Walks from q' to r' (side_of, verify/segments.h) through (r.x, q.y): sideways, then up or down. Returns the number
  /// of steps over edges before this walk. REQUIRES: the walker is at q'; `edges` has at least all edges that can meet
  /// the path.
  std::size_t walk(const Point& q, const Point& r, std::span<const std::uint32_t> edges);

  /// Undoes the last steps, until only this many remain.
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
