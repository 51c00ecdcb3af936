// The last step of every classic: its contours in the library's canonical order.
#pragma once

#include <oblast/region_set.h>

#include <optional>

#include "base/call_memory.h"
#include "graph/chain_graph.h"

namespace oblast::internal::window {

/// Closed walks along the boundary of a result.
class Contours {
 public:
  bool empty() const { return ends_.empty(); }
  void add(const Point& p) { points_.push_back(p); }
  /// Ends the contour whose points were added last; fewer than three points are dropped. `polygon`: the one that it
  /// bounds, where several may overlap.
  void close(std::uint32_t polygon = 0);

  /// The region set they bound, canonical (promise G3), under the `ogc` convention.
  /// REQUIRES: the result lies on the left; edges meet at their ends only. Cost: O(n + z log z), z contours.
  RegionSet to_region_set() const;

  /// The same where it is not known that every polygon lies on the left of its contours, nor that no two overlap:
  /// nothing when one of both does not hold. REQUIRES: edges meet at their ends only. Cost: O(n + z log z).
  std::optional<RegionSet> to_region_set_if_regular() const;

 private:
  ChainGraph graph(Array<std::uint8_t> flags) const;
  RegionSet single() const;

  Array<Point> points_;
  Array<std::uint32_t> ends_, polygons_;
};

}  // namespace oblast::internal::window
