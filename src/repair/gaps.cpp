// Step 2 of repair_coverage: enclosed pieces that no feature covers.
//
//   +-----------+    A frame around everything, without the pieces, falls into polygons: one outside of all pieces, and
//   |  aabbbbb  |    the gaps (g). Pieces that touch at points enclose a gap, too. All vertices of the pieces on its
//   |  aaggccc  |    border are vertices of a gap, so gaps and pieces have identical edges.
//   +-----------+
#include <oblast/domain.h>
#include <oblast/measure.h>
#include <oblast/overlay.h>

#include <algorithm>
#include <optional>

#include "repair/append_regions.h"
#include "repair/owned_pieces.h"
#include "repair/shared_borders.h"

namespace oblast::internal::repairing {
namespace {

/// Beyond all coordinates, or at the end of the domain.
double frame_side(double least) { return std::max(std::min(2 * least, 0.0) - 1, -domain_largest); }

/// A box around everything.
RegionSet frame_around(const Box& box) {
  const double x0 = frame_side(box.x0), y0 = frame_side(box.y0), x1 = -frame_side(-box.x1), y1 = -frame_side(-box.y1);
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {4}, {1}};
}

/// Whether a ring has a vertex on the frame's sides.
bool reaches_frame(std::span<const Point> ring, const RegionSet& frame) {
  const Point &low = frame.points[0], &high = frame.points[2];
  return std::any_of(ring.begin(), ring.end(),
                     [&](const Point& p) { return p.x == low.x || p.y == low.y || p.x == high.x || p.y == high.y; });
}

/// A gap with a vertex at the very end of the domain is not found.
RegionSet find_gaps(const RegionSet& pieces) {
  const std::optional<Box> box = bounds(pieces);
  if (!box) return {};
  const RegionSet frame = frame_around(*box);
  const RegionSet outside = overlay(frame, pieces, Operation::difference);
  RegionSet gaps;
  for (const PolygonView polygon : outside.polygons())
    if (!reaches_frame(polygon.contour(0), frame)) append_regions(polygon, gaps);
  return gaps;
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
