// Moves a walker over edges, forward and back.
#include "verify/walker.h"

#include <algorithm>

namespace oblast::verify {

std::size_t Walker::walk(const Point& q, const Point& r, std::span<const std::uint32_t> edges) {
  const std::size_t before = steps_.size();
  const Point corner{r.x, q.y};
  const auto [low_x, high_x] = std::minmax({q.x, r.x});
  const auto [low_y, high_y] = std::minmax({q.y, r.y});
  for (const std::uint32_t e : edges) {
    const Segment& s = segments_[e];
    if (spans_height_of(s, q) && std::max(s.from.x, s.to.x) >= low_x && std::min(s.from.x, s.to.x) <= high_x) {
      cross(e, side_of(s, q), side_of(s, corner));
    }
    if (spans_width_of(s, r) && std::max(s.from.y, s.to.y) >= low_y && std::min(s.from.y, s.to.y) <= high_y) {
      cross(e, side_of(s, corner), side_of(s, r));
    }
  }
  return before;
}

void Walker::cross(std::uint32_t edge, int side_before, int side_after) {
  if (side_before == side_after) return;
  here_.step_over(segments_[edge], side_after);
  steps_.push_back({edge, side_after});
}

void Walker::take_back(std::size_t steps) {
  while (steps_.size() > steps) {
    here_.step_over(segments_[steps_.back().edge], -steps_.back().side);
    steps_.pop_back();
  }
}

}  // namespace oblast::verify
