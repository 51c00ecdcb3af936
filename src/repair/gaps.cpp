// Step 2 of repair_coverage: enclosed pieces that no feature covers.
//
// The holes of the union of all pieces, without what of the union lies in them, are the gaps. All vertices of the pieces
// are vertices of the union where they lie on its boundary, so gaps and pieces have identical edges.
#include <oblast/overlay.h>

#include "repair/append_regions.h"
#include "repair/owned_pieces.h"
#include "repair/shared_borders.h"

namespace oblast::internal::repairing {
namespace {

RegionSet find_gaps(const RegionSet& pieces) {
  const RegionSet covered = unite(pieces);
  RegionSet holes;
  for (const PolygonView polygon : covered.polygons())
    append_regions(polygon.view().contours_between(1, polygon.contour_count()), holes);
  if (holes.empty()) return {};
  return overlay(holes, covered, Operation::difference);
}

}  // namespace

std::uint64_t close_gaps(OwnedPieces& pieces, const SizeBounds& bounds, std::vector<CoverageRepair>& changes) {
  const RegionSet gaps = find_gaps(pieces.regions);
  const std::size_t covered = pieces.owner.size();
  Array<std::uint32_t> closed;
  for (const PolygonView gap : gaps.polygons()) {
    if (!is_below(bounds, gap, twice_area(gap))) continue;
    closed.push_back(static_cast<std::uint32_t>(covered + closed.size()));
    append_regions(gap, pieces.regions);
  }
  const SharedBorders borders = find_shared_borders(pieces.regions, closed);
  for (std::size_t k = 0; k < closed.size(); ++k) {
    Array<OwnedLength> lengths;
    for (const SharedEdge& edge : borders.of(k)) lengths.push_back({pieces.owner[edge.neighbour], edge.length});
    const std::uint32_t owner = longest_owner(std::move(lengths));
    pieces.owner.push_back(owner);
    changes.push_back(change_of(CoverageChange::gap, {}, owner, pieces.regions.polygon(closed[k])));
  }
  return RegionView(gaps).polygon_count() - closed.size();
}

}  // namespace oblast::internal::repairing
