// Whether edges meet at common end points only.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace oblast::verify {

/// An edge without a direction.
struct PlainEdge {
  Point left, right;     ///< in lexicographic order
  std::uint32_t vertex;  ///< where it comes from, for messages

  friend bool operator==(const PlainEdge& e, const PlainEdge& f) { return e.left == f.left && e.right == f.right; }
};

/// Two edges that cross, overlap, or of which one touches the inside of the other. REQUIRES: no edge twice, none of
/// length zero. Cost: O(n log n), by the sweep of Shamos and Hoey 1976 with exact predicates.
std::optional<std::pair<PlainEdge, PlainEdge>> find_bad_meeting(const std::vector<PlainEdge>& edges);

}  // namespace oblast::verify
