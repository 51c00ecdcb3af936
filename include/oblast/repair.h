// Repairs layers: each feature by itself, or all of them together as a coverage.
#pragma once

#include <oblast/error.h>
#include <oblast/export.h>
#include <oblast/features.h>
#include <oblast/options.h>
#include <oblast/point.h>

#include <cstdint>
#include <span>
#include <vector>

namespace oblast {

/// What was wrong with a feature.
enum class RepairFault {
  too_few_points,         ///< a ring has fewer than three different points
  no_area,                ///< all points of a ring are on one line
  ring_crosses_itself,    ///< two edges of a ring cross
  ring_meets_itself,      ///< a ring goes through one of its vertices, or through a place on one of its edges, again
  spike,                  ///< a ring turns back on itself at a vertex
  ring_repeats_border,    ///< a ring runs along itself elsewhere
  rings_cross,            ///< edges of two rings of a polygon cross
  rings_share_border,     ///< two rings of a polygon run along each other, or are the same
  hole_outside,           ///< a hole is outside its outer ring, at least in part
  holes_overlap,          ///< a hole overlaps another one, or lies in it
  interior_parted,        ///< rings that touch cut the interior of a polygon into parts
  polygons_overlap,       ///< two polygons of the feature overlap, or one lies in the other
  polygons_share_border,  ///< two polygons of the feature run along each other
};

/// The fault in plain words, as in "two edges of a ring cross".
OBLAST_API const char* to_text(RepairFault fault);

/// What was changed of one feature. Areas are in squared units of the coordinates, computed in doubles.
struct FeatureRepair {
  std::uint32_t feature = 0;
  std::vector<RepairFault> faults;  ///< ascending; at least one
  std::uint32_t rings_before = 0;
  std::uint32_t rings_after = 0;
  std::uint32_t rings_dropped = 0;  ///< those before with fewer than three different points, or on one line
  /// Against the usual reading of polygons: what an outer ring winds around, and no hole does. So neither is zero in a
  /// bow-tie or where polygons overlap; places that a ring winds around twice are removed, and a hole outside its outer
  /// ring is added.
  double area_removed = 0;
  double area_added = 0;
  double area_after = 0;

  friend bool operator==(const FeatureRepair&, const FeatureRepair&) = default;
};

struct RepairOptions : CallOptions {};

struct Repaired {
  FeatureSet features;                 ///< row f is feature f, and its key is (f, no_feature)
  std::vector<FeatureRepair> changed;  ///< in the order of the features
};

/// Resolves each feature by itself: it becomes the union of its polygons, each the even-odd of its rings. Nothing
/// depends on the other features (promise G7).
///
/// A valid feature comes back with its own vertices, in their order and with their bits. Valid is what GIS programs
/// call so (OGC simple features), decided exactly: each ring is simple. Rings touch at single points. Holes are in
/// their outer rings, the interior of a polygon is connected, and interiors of polygons do not meet. Directions,
/// starts and order do not matter; a point may be repeated by the next one. All other features come back canonical, as
/// an overlay gives them. So every feature of the result is valid, and repairing it again changes nothing. A feature
/// without area comes back without polygons.
///
/// The result is the same on any number of threads. Features are repaired side by side.
/// Cost: O((n + k) log n), n edges, k pairs of edges of one feature that meet.
/// Throws Error: not_finite, out_of_domain, too_large, bad_offsets (these with the feature in their place), bad_option,
/// cancelled, memory_limit.
OBLAST_API Repaired repair(const FeatureView& features, const RepairOptions& options = {});

/// Shapefiles do not say which rings are holes of which. Of each feature in `without_roles` (ascending), every polygon
/// is taken as a heap of rings, filled by even-odd. If its rings bound several polygons, without crossing and each
/// once, it becomes these polygons. Rings keep their vertices, in their order and with their bits. All other polygons
/// stay as they are, and so do the other features. The key of row f is (f, no_feature). Cost: as `repair`. Throws
/// Error: as `repair`; bad_option also if `without_roles` does not ascend, or names a feature that there is not.
OBLAST_API FeatureSet group_rings(const FeatureView& features, std::span<const std::uint32_t> without_roles,
                                  const CallOptions& options = {});

/// To which of the features that overlap a place it goes.
enum class OverlapRule {
  first,    ///< the one that comes first in the layer
  largest,  ///< the one with the largest area, decided exactly; the first of several
};

/// Bounds of areas and widths: 0 closes nothing, infinity everything. The width of a piece is twice its area by its
/// perimeter: of a long strip its width, of a square half its side.
struct CoverageRepairOptions : CallOptions {
  OverlapRule overlaps = OverlapRule::first;
  double gaps_below = 0;        ///< gaps with less area are closed; decided exactly
  double gaps_narrower = 0;     ///< gaps of less width are closed; the width is computed in doubles
  double slivers_below = 0;     ///< slivers: parts of features with less area; decided exactly
  double slivers_narrower = 0;  ///< or of less width
};

enum class CoverageChange {
  overlap,  ///< features overlapped; one has the place now
  gap,      ///< no feature was there, but features all around
  sliver,   ///< a part of a feature went to another one
};

/// A piece that changed hands: a polygon of the arrangement of all features.
struct CoverageRepair {
  CoverageChange change;
  std::vector<std::uint32_t> from;  ///< features that lost it, ascending; none of a gap
  std::uint32_t to;                 ///< the feature that has it now
  double area;                      ///< in squared units of the coordinates
  Point at;                         ///< its smallest vertex

  friend bool operator==(const CoverageRepair&, const CoverageRepair&) = default;
};

struct RepairedCoverage {
  FeatureSet features;                  ///< row f is feature f, and its key is (f, no_feature)
  std::vector<CoverageRepair> changes;  ///< overlaps, then gaps, then slivers
  std::vector<std::uint32_t> changed;   ///< features that are not the same as before, ascending; see repair_coverage
  std::uint64_t gaps_left = 0;          ///< gaps that were not closed
};

/// Makes features a coverage: no two of them overlap, and borders that they share are the same vertices, bit for bit
/// (promise G8). All features enter one arrangement, each as `repair` reads it. Then
///
/// 1. each piece that several features cover goes to one of them, by `options.overlaps`;
/// 2. gaps, enclosed pieces that no feature covers, are closed if they are below a bound;
/// 3. slivers, parts of features that are below a bound, go to a neighbour. The largest part of a feature is none, nor
///    is a part without neighbours. This is repeated until there are no more.
///
/// Gaps and slivers go to the feature with which they share the longest border: lengths are computed in doubles and
/// added in canonical order; of equal ones the first feature counts. Areas are compared exactly.
///
/// A feature of which nothing changes, and which got no vertex from its neighbours, comes back with its own vertices,
/// in their order and with their bits; all other ones come back canonical. A feature that has lost everything comes
/// back without polygons. Repairing the result again with the same options changes nothing.
/// The result is the same on any number of threads.
/// Cost: O((n + k) log n) for each repetition of step 3; two are usual.
/// Throws Error: as `repair`; bad_option also if a bound is negative or not a number.
OBLAST_API RepairedCoverage repair_coverage(const FeatureView& features, const CoverageRepairOptions& options = {});

}  // namespace oblast
