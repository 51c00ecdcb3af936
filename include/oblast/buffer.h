// Buffer zones: the places within a distance of regions, lines and points.
//
//   RegionSet zone = oblast::buffer({.regions = fields}, 30);
//   RegionSet core = oblast::buffer({.regions = fields}, -30);
//   RegionSet road = oblast::buffer({.lines = roads}, 5, {.cap = oblast::Cap::flat});
#pragma once

#include <oblast/error.h>
#include <oblast/export.h>
#include <oblast/features.h>
#include <oblast/options.h>
#include <oblast/region_set.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace oblast {

/// Lines in a caller's arrays, viewed without copying them. Line l is the open path through the points
/// [line_ends[l-1], line_ends[l]). A line whose last point is its first has no ends. Lines may cross themselves and
/// each other. A line of one point, or of equal points, is a point.
struct LineView {
  std::span<const Point> points{};
  std::span<const std::uint32_t> line_ends{};  ///< not decreasing; the last one is the number of points

  std::size_t size() const { return line_ends.size(); }
  std::span<const Point> operator[](std::size_t l) const {
    const std::uint32_t begin = l == 0 ? 0 : line_ends[l - 1];
    return points.subspan(begin, line_ends[l] - begin);
  }
};

/// Regions, lines and points together. Each may be empty.
struct ShapeView {
  RegionView regions{};
  LineView lines{};
  std::span<const Point> points{};
};

/// The outline around a convex corner.
enum class Join {
  round,
  mitre,  ///< both sides go on until they meet, but not further from the corner than BufferOptions::mitre_limit
  bevel,  ///< the two sides are joined by a straight edge
};

/// The outline around the end of a line. Of a single point, `square` makes a square, and `flat` makes nothing.
enum class Cap { round, flat, square };

/// The sides of lines that count, as seen along the line. One-sided zones have no caps.
enum class Side { both, left, right };

/// On which side of the true outline the outline may be. f is the relative tolerance, C = BufferStatistics::rounding.
enum class BufferMode {
  nearest,  ///< between (1 - f) d - C and (1 + f) d + C from the input; the fewest vertices
  inside,   ///< between (1 - f) d - C and d: nothing that is further than d
  outside,  ///< between d and (1 + f) d + C: everything that is not further than d
};

/// What a call did. A call that succeeds fills it if BufferOptions::statistics points to one.
struct BufferStatistics {
  std::uint64_t directions = 0;      ///< of the arcs, in a whole circle
  std::uint64_t corners = 0;         ///< vertices of the outlines that were offset
  std::uint64_t closed_pockets = 0;  ///< see `buffer`
  std::uint64_t folded_pieces = 0;   ///< pieces that rounding folded; the hull of their vertices takes their place
  double lower_factor = 1;           ///< the outline is not nearer than this times d, less `rounding`
  double upper_factor = 1;           ///< the outline is not further than this times d, and `rounding`
  double rounding = 0;               ///< C, in units of the coordinates: 48 units in the last place of the largest one
  Statistics overlay;                ///< of the union of all pieces
};

/// The options of a buffer.
struct BufferOptions : CallOptions {
  FillRule fill;  ///< what is inside the regions
  Join join = Join::round;
  double mitre_limit = 5;  ///< as a multiple of the distance, 1 or more
  Cap cap = Cap::round;
  Side side = Side::both;
  BufferMode mode = BufferMode::nearest;
  double tolerance = 0.01;        ///< f: relative to the distance, from 1e-9 to 0.5
  double absolute_tolerance = 0;  ///< if above 0: f is this by the distance, but not outside of that range
  BufferStatistics* statistics = nullptr;
};

/// The zone of the shapes: all places that are not further than `distance` from them. If the distance is negative, all
/// places of the regions that are further than its magnitude from the boundary of their union; lines and points then
/// count as nothing. Distance 0 gives the union of the regions.
///
/// The zone is the union of the regions and of a piece for each edge and corner, by winding numbers (docs/buffers.md).
/// The result is closed, canonical, the same on every machine, and local: promises G2, G3, G3b, G7.
/// Distance: round joins and caps keep the outline within the bounds of BufferOptions::mode. So do the other joins and
/// caps along edges, but not around corners and ends.
/// Containment: a zone of positive distance holds the shapes, one of negative distance lies in the regions: exactly,
/// but for bevels and flat caps, which go through corners and ends of the shapes, and may leave them out by C.
/// Monotone: with the same relative tolerance, a larger distance gives a larger zone, up to C, or, where pockets are
/// closed, up to the bounds.
/// Where edges are much shorter than the distance, pockets are closed that are too narrow to change the outline by more
/// than the tolerance (round joins only), so coastlines buffered by kilometres are quick.
///
/// REQUIRES, else Error(bad_option): `distance` is finite, and the zone fits the domain (domain.h).
/// Cost: O((n + k) log n), n edges of the shapes, k the meetings of pieces.
/// Throws Error: not_finite, out_of_domain, too_large, bad_offsets, bad_option, cancelled, memory_limit. The operand of
/// its place is 0 for regions, 1 for lines, 2 for points.
OBLAST_API RegionSet buffer(const ShapeView& shapes, double distance, const BufferOptions& options = {});

/// Shapes with rows: `region_rows[p]` is the row of polygon p, and so on. If they are empty, every polygon, line and
/// point is a row of its own, in this order.
struct ShapeFeatures {
  ShapeView shapes{};
  std::span<const std::uint32_t> region_rows{};
  std::span<const std::uint32_t> line_rows{};
  std::span<const std::uint32_t> point_rows{};
};

/// A zone for each row. Row f is the zone of the shapes of row f alone by `distances[f]`, bit for bit what `buffer`
/// gives for them, with the key (f, no_feature). Rows may overlap, and their edges may cross. There is a row for every
/// distance. REQUIRES, else Error(bad_option): row numbers are below distances.size().
/// Errors and cost as `buffer`. Rows are computed side by side. Of the statistics, counts are added, and of the rest
/// the largest is taken.
OBLAST_API FeatureSet buffer_rows(const ShapeFeatures& features, std::span<const double> distances,
                                  const BufferOptions& options = {});

}  // namespace oblast
