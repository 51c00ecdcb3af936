// The inside of a frame, for boxes.
#pragma once

#include <oblast/region_set.h>

#include "base/memory_budget.h"
#include "locate/edges.h"
#include "locate/prepared_regions.h"
#include "plane/box.h"
#include "plane/box_tree.h"

namespace oblast::internal::zoning {

class FrameInterior {
 public:
  /// The frame is the union of its polygons. Cost: O(n log n). REQUIRES: it is destroyed within the call.
  explicit FrameInterior(const RegionView& frame);

  /// Whether all of the box is inside, and no edge of the frame meets it. No for a box in an even number of polygons.
  /// Cost: O(log n + k), k edges whose boxes meet the box.
  bool holds(const Box& box) const;

 private:
  Charge charge_;  ///< of the edges
  locate::Edges edges_;
  BoxTree boxes_;
  locate::PreparedRegions regions_;
};

}  // namespace oblast::internal::zoning
