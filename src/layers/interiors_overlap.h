// Decides exactly whether the interiors of two simple contours have a point in common.
//
//   1. Two edges cross at an interior point of both: yes.
//   2. The boundaries touch at x. There the interior of each contour is one sector. If the open sectors overlap at any
//      touching point: yes. Otherwise no: a boundary that leaves the other's interior passes through a touching point
//      at which the sectors overlap.
//   3. The boundaries do not meet: one contour is inside the other, or they are disjoint. One vertex decides.
//
//           \  Q /
//            \  /          There is no rounding. Touching points are vertices: edges that
//      -------x-------     meet at other points cross.
//             P
#pragma once

#include <cstdint>
#include <utility>

#include "base/call_memory.h"
#include "layers/contour_trees.h"

namespace oblast::internal {

class InteriorTest {
 public:
  /// A tangled contour counts as overlapping. Cost: the number of pairs of leaves whose boxes meet.
  bool overlap(const ContourTree& p, const ContourTree& q);

 private:
  enum class Meeting { apart, touch, overlap };

  Meeting boundaries(const ContourTree& p, const ContourTree& q);
  bool inside(const Point& x, const ContourTree& contour);

  Array<std::pair<std::uint32_t, std::uint32_t>> pairs_;  ///< nodes to compare
  Array<std::uint32_t> nodes_;                            ///< nodes to look into
};

}  // namespace oblast::internal
