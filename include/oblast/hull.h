// Convex hulls: of a simple contour in linear time, and of any region set.
#pragma once

#include <oblast/error.h>
#include <oblast/export.h>
#include <oblast/options.h>
#include <oblast/region_set.h>

#include <span>
#include <vector>

namespace oblast {

/// The convex hull of the points of a contour. Returns its corners counter-clockwise, starting at the lexicographically
/// smallest one. Corners are input points, bit for bit (except that -0.0 becomes 0.0), and no three neighbours are
/// collinear. If all points are collinear, there are fewer than three corners.
///
/// The method is Lee's scan with one stack (1983; Preparata and Shamos, section 4.1.4). It is correct for simple
/// contours in either direction. A second pass compares every point with the edge of the hull above or below it. If
/// this check fails, because the contour is not simple, the monotone chain (Andrew 1979) computes the hull. So the
/// result is the hull of the points for any contour.
/// Cost: O(n) for simple contours, O(n log n) for others. The check searches edges in buckets of equal width in x. In
/// the worst case, if one bucket holds all corners, it takes O(n log n).
/// Throws Error: not_finite, out_of_domain, too_large, bad_option, cancelled, memory_limit.
OBLAST_API std::vector<Point> hull(std::span<const Point> contour, const CallOptions& options = {});

/// The convex hull of all regions as one polygon: the hull of the hulls of all contours. It is empty if all points are
/// collinear. Cost: O(n + h log h) for simple contours whose hulls have h corners in total.
/// Throws Error: as above, and bad_offsets.
OBLAST_API RegionSet hull(const RegionView& regions, const CallOptions& options = {});

}  // namespace oblast
