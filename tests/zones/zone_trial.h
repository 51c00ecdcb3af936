// One hostile case of proximity zones, and whether every promise held.
#pragma once

#include <oblast/zones.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generators/hostile.h"

namespace oblast::testing {

enum class BrokenZones { rows, cover, nearness, statistics, order, threads, voronoi, company, threw };
inline constexpr int broken_zones_count = 9;
const char* to_text(BrokenZones broken);

struct ZoneFailure {
  BrokenZones broken;
  std::string what;
};

/// Objects that own their arrays, with the frame and the options of a call.
struct ZoneQuestion {
  RegionSet regions;
  std::vector<Point> line_points, points;
  std::vector<std::uint32_t> line_ends;
  std::vector<std::uint32_t> region_rows, line_rows, point_rows;  ///< all empty: every shape is an object
  RegionSet frame;                                                ///< empty: the box that zones() takes
  ZoneOptions options;

  ShapeFeatures view() const {
    return {{regions, {line_points, line_ends}, points}, region_rows, line_rows, point_rows};
  }
  std::size_t object_count() const;
  bool is_numbered() const;  ///< whether shapes have numbers of objects
  void number_shapes();      ///< every shape is an object. REQUIRES: it is not numbered
  bool has_points_only() const { return regions.contour_ends.empty() && line_ends.empty(); }
  void add_line(std::span<const Point> line);
};

/// The worst figures of a run.
struct ZoneFigures {
  double proved = 0;  ///< the epsilon that was proved, by the one that was asked for
  double seen = 0;    ///< the epsilon that was seen, by the one that was proved (with C)
  std::uint64_t sites = 0, excused = 0;

  void add(const ZoneFigures& other);
};

/// A question drawn from the operands: polygons, their outlines as lines, their vertices as points, or all of them; one
/// object a shape, or several shapes an object; without a frame, in a box, or in the polygons of B; with tolerances
/// from 1e-9 to 0.1 of the extent; sometimes with a largest distance.
ZoneQuestion draw_zones(const generators::Operands& operands, std::uint64_t seed);

/// rows: a row for each object, with its number. cover: verify::check_zone_cover (Z1, Z2). nearness:
/// verify::check_zone_distances (Z3) with the proved epsilon. statistics: the proved epsilon is not above the one asked
/// for. order: shapes within objects in another order and direction. threads: two of them. voronoi: cells of a few
/// points in a box, vertex by vertex (asked where `voronoi` is set; hostile cells may cross when they are rounded).
/// company: all of the first four again, when an object is added that is far from the frame.
struct ZoneTrial {
  std::uint64_t seed = 1;
  std::uint64_t places = 500;
  bool voronoi = false;
};
std::optional<ZoneFailure> run_zone_trial(const ZoneQuestion& question, const ZoneTrial& trial,
                                          ZoneFigures* figures = nullptr);
/// The question in words, to ask it again.
std::string to_text(const ZoneQuestion& question);

}  // namespace oblast::testing
