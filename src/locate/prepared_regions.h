// Regions prepared for queries: points are located by the cell of a grid that they are in, and those in crowded cells
// by the tree of slabs.
#pragma once

#include <oblast/locator.h>

#include <optional>
#include <span>

#include "locate/cell_grid.h"
#include "locate/edges.h"
#include "locate/slab_tree.h"

namespace oblast::internal::locate {

/// See Locator for what it promises. REQUIRES: regions and points are valid; floating point is in its default modes.
class PreparedRegions {
 public:
  explicit PreparedRegions(Edges edges);
  PreparedRegions(const PreparedRegions&) = delete;
  PreparedRegions& operator=(const PreparedRegions&) = delete;

  Location locate(const Point& p) const;
  void locate(std::span<const Point> points, Location* locations) const;

 private:
  Location location(CellAnswer answer, const Point& p) const {
    return answer == CellAnswer::crowded ? slabs_->locate(p) : static_cast<Location>(answer);
  }

  Edges edges_;  ///< where there are slabs
  CellGrid grid_;
  std::optional<SlabTree> slabs_;
};

}  // namespace oblast::internal::locate
