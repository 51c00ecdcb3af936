#include "repair/describe_repair.h"

#include <oblast/measure.h>
#include <oblast/overlay.h>

#include <algorithm>

#include "repair/append_regions.h"
#include "repair/ring_faults.h"

namespace oblast {

const char* to_text(RepairFault fault) {
  switch (fault) {
    case RepairFault::too_few_points:
      return "a ring has fewer than three different points";
    case RepairFault::no_area:
      return "all points of a ring are on one line";
    case RepairFault::ring_crosses_itself:
      return "two edges of a ring cross";
    case RepairFault::ring_meets_itself:
      return "a ring touches itself";
    case RepairFault::spike:
      return "a ring has a spike";
    case RepairFault::ring_repeats_border:
      return "a ring runs along itself";
    case RepairFault::rings_cross:
      return "edges of two rings cross";
    case RepairFault::rings_share_border:
      return "two rings run along each other";
    case RepairFault::hole_outside:
      return "a hole is outside its outer ring";
    case RepairFault::holes_overlap:
      return "a hole overlaps another hole or lies in it";
    case RepairFault::interior_parted:
      return "rings that touch cut the interior into parts";
    case RepairFault::polygons_overlap:
      return "polygons of the feature overlap";
    case RepairFault::polygons_share_border:
      return "polygons of the feature share a border";
  }
  return "";
}

}  // namespace oblast

namespace oblast::internal::repairing {
namespace {

Options with_rule(const FillRule& rule) {
  Options options;
  options.fill_a = options.fill_b = rule;
  return options;
}

/// Whether some place is in two of the polygons.
bool do_overlap(const RegionView& polygons) {
  return polygons.polygon_count() > 1 && !unite(polygons, with_rule(FillRule::at_least(2))).empty();
}

/// One polygon: its outer ring and its holes, each hole a polygon.
struct Parts {
  RegionView outer, holes;

  explicit Parts(const RegionView& polygon)
      : outer(polygon.contours_between(0, std::min<std::size_t>(1, polygon.contour_count()))),
        holes(polygon.contours_between(outer.contour_count(), polygon.contour_count())) {}
};

/// What outer rings wind around and holes do not.
RegionSet usual_reading(const RegionView& feature) {
  RegionSet all;
  for (const PolygonView polygon : feature.polygons()) {
    const Parts parts(polygon);
    append_regions(overlay(parts.outer, parts.holes, Operation::difference, with_rule(FillRule::nonzero())), all);
  }
  return all;
}

FaultSet find_misplaced(const RegionView& feature) {
  FaultSet faults;
  for (const PolygonView polygon : feature.polygons()) {
    const Parts parts(polygon);
    if (parts.holes.contour_count() > 0) {
      if (do_overlap(parts.holes)) faults.add(RepairFault::holes_overlap);
      if (!overlay(parts.holes, parts.outer, Operation::difference, with_rule({})).empty())
        faults.add(RepairFault::hole_outside);
    }
  }
  if (do_overlap(feature)) faults.add(RepairFault::polygons_overlap);
  return faults;
}

}  // namespace

FeatureRepair describe_repair(const RegionView& feature, const RegionSet& resolved) {
  FeatureRepair report;
  FaultSet faults = find_ring_faults(feature, report.rings_dropped);
  faults.add(find_misplaced(feature));
  // A feature with none of these is not valid for one reason only.
  if (faults.empty()) faults.add(RepairFault::interior_parted);
  for (int f = 0; f <= static_cast<int>(RepairFault::polygons_share_border); ++f)
    if (faults.has(static_cast<RepairFault>(f))) report.faults.push_back(static_cast<RepairFault>(f));
  report.rings_before = static_cast<std::uint32_t>(feature.contour_count());
  report.rings_after = static_cast<std::uint32_t>(resolved.contour_ends.size());
  const RegionSet before = usual_reading(feature);
  report.area_removed = signed_area(overlay(before, resolved, Operation::difference));
  report.area_added = signed_area(overlay(resolved, before, Operation::difference));
  report.area_after = signed_area(resolved);
  return report;
}

}  // namespace oblast::internal::repairing
