// Whether the interiors of two simple contours have a point in common, exactly.
//
//   1. Two edges cross inside both: yes.
//   2. The boundaries touch at x. Each contour's interior there is one sector. If the open sectors of
//      some touching point overlap: yes. Otherwise no: where a boundary leaves the other's interior, it passes
//      a touching point, and the sectors there overlap.
//   3. The boundaries do not meet: one contour is inside the other, or they are apart. One vertex decides.
//
//           \  Q /
//            \  /          no rounding: touching points are vertices, for edges that meet
//      -------x-------     elsewhere cross
//             P
#pragma once

#include <cstdint>
#include <utility>

#include "base/call_memory.h"
#include "layers/contour_trees.h"

namespace oblast::internal {

class InteriorTest {
 public:
  /// A tangled contour counts as overlapping. Cost: the pairs of leaves whose boxes meet.
  bool overlap(const ContourTree& p, const ContourTree& q);

 private:
  enum class Meeting { apart, touch, overlap };

  Meeting boundaries(const ContourTree& p, const ContourTree& q);
  bool inside(const Point& x, const ContourTree& contour);

  Array<std::pair<std::uint32_t, std::uint32_t>> pairs_;  ///< nodes to compare
  Array<std::uint32_t> nodes_;                            ///< nodes to look into
};

}  // namespace oblast::internal
