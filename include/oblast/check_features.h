// Whether features are what a GIS takes them for: each a valid polygon or multipolygon of the OGC, and, as a coverage,
// without overlaps, gaps and vertices that a neighbour does not have. All faults are found, not only the first.
#pragma once

#include <oblast/export.h>
#include <oblast/features.h>
#include <oblast/options.h>
#include <oblast/point.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace oblast {

/// What may be wrong with a feature, or between two. A *shell* is the first ring of a polygon, its other rings are
/// *holes*; the polygons of a feature are its *parts*.
enum class FeatureFaultKind : std::uint8_t {
  ring_not_closed,  ///< its last point is not its first; the caller says so (FeatureCheckOptions)
  too_few_points,   ///< a ring has fewer than three different points in a row
  spike,            ///< an edge goes back along the one before

  ring_crosses_itself,
  ring_touches_itself,     ///< a ring goes through a point twice without crossing itself
  ring_runs_along_itself,  ///< a ring goes along a line twice, as at a bridge to a hole
  repeated_ring,           ///< a shell or a hole is there twice

  hole_crosses_shell,
  hole_outside_shell,
  holes_overlap,     ///< two holes of a part cross, or one lies in the other
  rings_share_edge,  ///< two rings of a part run along one line; only points may be common
  interior_cut,      ///< rings of a part touch, and so cut its interior in two

  parts_overlap,     ///< two parts cross, or one lies in the other
  parts_share_edge,  ///< two parts run along one line: they should be one part

  repeated_vertex,    ///< a note: a vertex is equal to the next one
  wrong_orientation,  ///< a note: a shell runs clockwise, or a hole counter-clockwise

  overlap,              ///< features cover one area
  gap,                  ///< an area that several features enclose and none covers
  t_junction,           ///< a vertex lies on an edge of another feature, and its border turns away there
  mismatched_vertices,  ///< a border of two features has a vertex, on an edge of one of them, that this one has not
};
inline constexpr std::size_t feature_fault_kinds = 20;

/// The kind in a few words: "ring crosses itself".
OBLAST_API const char* name(FeatureFaultKind kind);

/// Whether it is a note: the feature is valid all the same.
constexpr bool is_note(FeatureFaultKind kind) {
  return kind == FeatureFaultKind::repeated_vertex || kind == FeatureFaultKind::wrong_orientation;
}

/// A vertex of a feature; where an edge is at fault, the vertex at which it begins.
struct FeaturePlace {
  static constexpr std::uint32_t none = 0xffffffff;
  std::uint32_t feature = none;
  std::uint32_t contour = none;  ///< counted through all features, as in `FeatureView::regions`
  std::uint32_t vertex = none;   ///< counted within the contour; `none`: all of the contour, or of the feature

  friend auto operator<=>(const FeaturePlace&, const FeaturePlace&) = default;
};

struct FeatureFault {
  FeatureFaultKind kind;
  FeaturePlace place;
  FeaturePlace other;  ///< the second vertex, edge, ring or feature; all `none` if there is none
  Point point;         ///< where; of a crossing it is the nearest double
  double area = 0;     ///< of an overlap or a gap, in squared units; 0 for all others

  friend bool operator==(const FeatureFault&, const FeatureFault&) = default;
};

struct FeatureCheckOptions : CallOptions {
  /// The contours, ascending, that the caller's file does not close. Views have no closing points, so only a reader
  /// knows.
  std::span<const std::uint32_t> open_contours;
  /// The features, ascending, whose rings have no roles in the file: each polygon of theirs is a heap of rings, a ring
  /// in an even number of others is a shell, and the others are holes (records of shapefiles).
  std::span<const std::uint32_t> features_without_roles;
};

/// All faults and notes of each feature by itself, in the order of features, contours, vertices and kinds; the same on
/// any number of threads. Closing points are not expected: a first vertex repeated at the end is a repeated vertex.
/// Where rings run along one line, that is one fault for each stretch. Whether a ring lies in another one is judged of
/// rings that do not cross, spike or run along anything.
///
/// Every decision is exact. Cost: O((n + k) log n) time, n edges, k pairs of edges of one feature that meet; O(n + k)
/// memory. Throws Error: bad_offsets, not_finite, out_of_domain, too_large, bad_option, cancelled, memory_limit.
OBLAST_API std::vector<FeatureFault> check_features(const FeatureView& features,
                                                    const FeatureCheckOptions& options = {});

/// All faults between features, in the same order. Whether there is one is decided exactly. An overlap is one fault for
/// each connected area; it names two features, and there may be more. Overlaps and gaps are those of the arrangement
/// that overlays make, which is exact where no borders cross; crossings are rounded to the nearest double. Holes of one
/// feature by itself are no gaps.
///
/// Cost and errors as of `overlay_features`.
OBLAST_API std::vector<FeatureFault> check_coverage(const FeatureView& features, const CallOptions& options = {});

}  // namespace oblast
