// The pieces of a coverage under repair: polygons that do not overlap, each with the feature that has it.
#pragma once

#include <oblast/repair.h>

#include <cstdint>

#include "base/call_memory.h"
#include "base/memory_budget.h"
#include "repair/size_bounds.h"

namespace oblast::internal::repairing {

struct OwnedPieces {
  Charge charge;  ///< for the regions
  RegionSet regions;
  Array<std::uint32_t> owner;  ///< by polygon
};

/// A piece that changed hands.
inline CoverageRepair change_of(CoverageChange change, std::vector<std::uint32_t> from, std::uint32_t to,
                                const RegionView& piece) {
  return {change, std::move(from), to, signed_area(piece), piece.points[0]};
}

/// The pieces of each owner united: a row for each of `features` features. Nothing is rounded.
FeatureSet unite_by_owner(const OwnedPieces& pieces, std::size_t features);

/// Step 1 of repair_coverage: cuts the features into pieces, each of one owner.
OwnedPieces share_out_overlaps(const FeatureView& layer, OverlapRule rule, std::vector<CoverageRepair>& changes);

/// Step 2: adds gaps below the bounds to the pieces. The number of gaps that are left.
std::uint64_t close_gaps(OwnedPieces& pieces, const SizeBounds& bounds, std::vector<CoverageRepair>& changes);

/// Step 3: gives slivers to neighbours until there are none.
void move_slivers(FeatureSet& rows, const SizeBounds& bounds, std::vector<CoverageRepair>& changes);

}  // namespace oblast::internal::repairing
