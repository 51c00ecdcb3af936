// Proximity zones: which object is nearest. Objects are points, lines, polygons, or several of them.
//
//   FeatureSet served = oblast::zones({.shapes = {.points = schools}});
//   FeatureSet plots = oblast::zones({.shapes = {.regions = buildings}}, blocks, {.tolerance = 0.1, .distance = 100});
#pragma once

#include <oblast/buffer.h>
#include <oblast/error.h>
#include <oblast/export.h>
#include <oblast/features.h>
#include <oblast/options.h>
#include <oblast/region_set.h>

#include <cstdint>
#include <limits>

namespace oblast {

/// What a call did. A call that succeeds fills it if ZoneOptions::statistics points to one.
struct ZoneStatistics {
  std::uint64_t sites = 0;   ///< points that stand for the objects: the points, and samples of lines and outlines
  std::uint64_t rounds = 0;  ///< of sampling; 1 for points alone
  double tolerance = 0;      ///< epsilon as it was asked for, or 2 C if that is more, in units of the coordinates
  double error = 0;          ///< the epsilon that was needed: proved by the samples; 0 for points alone
  double rounding = 0;       ///< C, in units of the coordinates; zones are exact up to `error` + C
  Statistics overlay;        ///< of the arrangement of objects, borders and frame
};

/// The options of zones.
struct ZoneOptions : CallOptions {
  double tolerance = 0;              ///< epsilon in units of the coordinates; 0: `relative_tolerance` decides
  double relative_tolerance = 1e-5;  ///< epsilon by the larger side of the box of all objects, from 1e-12 to 0.1
  /// How far a zone may reach from its object. If it is finite, zones end where no object is within the distance: they
  /// hold every place that is nearer, less C, and none that is further by more than twice epsilon and C. (Epsilon counts
  /// as a billionth of the distance here if that is more.)
  double distance = std::numeric_limits<double>::infinity();
  ZoneStatistics* statistics = nullptr;
};

/// The zone of each object within the frame: the places to which no other object is nearer.
///
/// Row i of the result is the zone of object i, with the key (i, no_feature). Object i is all shapes with the row
/// number i; there is a row for every number up to the largest one. Polygons are the even-odd of their own rings. The
/// frame is the union of its polygons. If it is empty, it is the box of all objects with a margin: a tenth of its
/// larger side (of a single place: 1, or 2^-20 of its largest coordinate if that is more), or one and a half times
/// `distance` if that is finite.
///
/// Coverage (Z1): zones leave no gap in the frame (but for places beyond `distance`) and do not overlap; they share
/// their borders bit for bit, as promise G8 says.
/// Containment (Z2): each object lies in its own zone, as far as it is in the frame. Where polygons overlap, the lower
/// number has the place. Lines and points within a polygon of another object, and points on its outline or on a line,
/// do not count: they have no area to give to a zone. Where lines coincide with each other or with outlines, and of equal
/// points, the lower number counts. So the zone of an object that others cover is empty. (Exactly but for edges that are
/// cut at places that are no doubles: these may have moved by C.)
/// Nearness (Z3): at every place of zone i, the distance from object i is at most the distance from any other object
/// plus ZoneStatistics::error plus C. For points alone, vertices are circumcentres, correctly rounded.
/// Objects that touch share the places that are as near to one as to the other: they are parted by the bisector.
///
/// Edges of no length count as nothing: a line of equal points is a point, and a polygon without area is left out. So may
/// be parts of polygons that are thinner than C, which rounding may close.
/// Objects outside of the frame have the part of their zone that is in the frame.
/// The result is canonical, and the same on every machine (promises G3, G3b). It does not depend on the order of shapes
/// within rows.
///
/// REQUIRES, else Error(bad_option): tolerances are finite and in their range; `distance` is above 0; the frame and the
/// objects, widened by eight times their extent, fit the domain (domain.h).
/// Cost: O((n + k + s) log (n + s)), n edges, k crossings, s sites.
/// Throws Error: not_finite, out_of_domain, too_large, bad_offsets, bad_option, cancelled, memory_limit. The operand of
/// its place is 0 for regions, 1 for lines, 2 for points, 3 for the frame.
OBLAST_API FeatureSet zones(const ShapeFeatures& objects, const RegionView& frame = {},
                            const ZoneOptions& options = {});

}  // namespace oblast
