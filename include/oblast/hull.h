// Convex hulls: of a simple contour in linear time, and of any region set.
#pragma once

#include <oblast/error.h>
#include <oblast/export.h>
#include <oblast/options.h>
#include <oblast/region_set.h>

#include <span>
#include <vector>

namespace oblast {

/// The convex hull of a contour by Lee's scan with one stack (Preparata and Shamos, section 4.1.4).
/// The corners counter-clockwise from the lexicographically smallest one, exact, without collinear
/// ones; fewer than three where the points are collinear.
///
/// The scan is right for simple contours, in either direction, and its answer is checked in one more pass
/// over the points, each against the hull's edge above or below it; where a contour is not simple and the scan fell for
/// it, the hull is taken by the monotone chain (Andrew 1979). So the answer is the hull of the points in any case.
/// Throws Error: not_finite, out_of_domain, too_large, bad_option, cancelled, memory_limit. Cost: O(n) for simple
/// contours (the check finds edges by buckets: a logarithm of the corners in one bucket at worst), O(n log n)
/// otherwise.
OBLAST_API std::vector<Point> hull(std::span<const Point> contour, const CallOptions& options = {});

/// The convex hull of all regions as one polygon, empty where they have no area: the hull of the hulls of
/// all contours. Cost: O(n + h log h), h corners of the contours' hulls together.
/// Throws Error: as above, and bad_offsets.
OBLAST_API RegionSet hull(const RegionView& regions, const CallOptions& options = {});

}  // namespace oblast
