#include "buffer/zone.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/index.h"
#include "base/parallel.h"
#include "base/stage_shares.h"
#include "buffer/line_walks.h"
#include "buffer/outline.h"
#include "buffer/pockets.h"
#include "buffer/zone_shape.h"
#include "overlay/report.h"
#include "plane/largest_ulp.h"

namespace oblast::internal::buffering {
namespace {

class Zone {
 public:
  Zone(const ShapeView& shapes, double distance, const BufferOptions& options, Control& control)
      : shapes_(shapes), distance_(distance), options_(options), control_(control) {}

  PipelineResult run(BufferStatistics& statistics) {
    PipelineResult united;
    if (!shapes_.regions.points.empty()) {
      const Share share(buffer_union_share);
      united = overlay(shapes_.regions, options_.fill, statistics.overlay);
    }
    if (distance_ == 0) return united;
    const ZoneShape shape(std::fabs(distance_), options_);
    double largest = largest_coordinate(shapes_.regions.points);
    if (distance_ > 0)
      largest = std::max({largest, largest_coordinate(shapes_.lines.points), largest_coordinate(shapes_.points)});
    statistics.rounding = shape.rounding(largest);
    statistics.directions = shape.directions.count();
    statistics.lower_factor = shape.lower_factor;
    statistics.upper_factor = shape.upper_factor;
    const Outlines outlines = outlines_of(united.regions, shape, statistics);
    united = {};
    statistics.overlay = {};
    const RegionView pieces{outlines.points, outlines.contour_ends, {}};
    return overlay(pieces, distance_ > 0 ? FillRule::positive() : FillRule::negative(), statistics.overlay);
  }

 private:
  PipelineResult overlay(const RegionView& regions, const FillRule& fill, Statistics& statistics) {
    Options options;
    options.fill_a = fill;
    if (options_.statistics) options.statistics = &statistics;  // else the pipeline measures nothing
    PipelineResult result = run_pipeline(regions, nullptr, {Operation::unite, options, control_}, statistics);
    report(std::span(&regions, 1), result.regions, statistics);
    return result;
  }

  /// Walks around regions, lines and points, in ranges on all cores.
  Outlines outlines_of(const RegionView& united, const ZoneShape& shape, BufferStatistics& statistics) const {
    const std::size_t contours = united.contour_count();
    const std::size_t lines = distance_ > 0 ? shapes_.lines.size() : 0;
    const Array<Point> points = distance_ > 0 ? different_points() : Array<Point>();
    const std::size_t count = contours + lines + points.size();
    const std::size_t vertices = united.points.size() + shapes_.lines.points.size() + points.size();
    const std::size_t size = grain(count, vertices);
    struct Part {
      Outlines outlines;
      std::uint64_t pockets = 0;
    };
    Array<Part> parts(range_count(count, size));
    for_numbered_ranges(count, size, [&](std::size_t r, std::size_t i, std::size_t end) {
      for (Part& part = parts[r]; i < end; ++i) {
        poll();
        if (i < contours)
          add_contour(united.contour(i), shape, part.outlines, part.pockets);
        else if (i < contours + lines)
          add_line(shapes_.lines[i - contours], shape, part.outlines, part.pockets);
        else
          append_point_outline(shape, points[i - contours - lines], part.outlines);
      }
    });
    Outlines all;
    for (Part& part : parts) {
      append(std::move(part.outlines), all);
      statistics.closed_pockets += part.pockets;
    }
    statistics.corners = all.corners;
    statistics.folded_pieces = all.folded_pieces;
    return all;
  }

  void add_contour(std::span<const Point> contour, const ZoneShape& shape, Outlines& outlines,
                   std::uint64_t& pockets) const {
    Array<Point> path(contour.begin(), contour.end());
    path.push_back(contour.front());
    if (distance_ < 0) std::reverse(path.begin(), path.end());
    if (Array<Point> fewer = without_near(path, shape); fewer.size() < path.size()) {
      // Without some of its vertices the contour may cross itself, so its sides are no longer known: it gets pieces on
      // both, as a line does.
      append_bare(path, outlines);
      return add_path(fewer, Side::both, shape, outlines, pockets);
    }
    Walk walk;
    if (shape.widest_lid > 0) {
      ClosedPath closed = close_pockets(path, shape.widest_lid, false);
      pockets += closed.pockets;
      walk = std::move(closed.right);
    } else {
      walk = plain_walk(path);
    }
    walk.pop_back();
    append_outline(shape, walk, outlines);
  }

  void add_line(std::span<const Point> line, const ZoneShape& shape, Outlines& outlines, std::uint64_t& pockets) const {
    add_path(without_near(line_path(line, options_.side), shape), options_.side, shape, outlines, pockets);
  }

  void add_path(const Array<Point>& path, Side side, const ZoneShape& shape, Outlines& outlines,
                std::uint64_t& pockets) const {
    if (path.size() == 1) append_point_outline(shape, path[0], outlines);
    if (path.size() < 2) return;
    for (const Walk& walk : line_walks(path, side, options_.cap, shape.widest_lid, pockets))
      append_outline(shape, walk, outlines);
  }

  static Array<Point> without_near(const Array<Point>& path, const ZoneShape& shape) {
    return buffering::without_near(path, [&](const Point& p, const Point& q) { return shape.is_near(p, q); });
  }

  Array<Point> different_points() const {
    Array<Point> points;
    for (const Point& p : shapes_.points) points.push_back({p.x + 0.0, p.y + 0.0});
    parallel_sort(points.begin(), points.end(), lexicographically_less);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
  }

  static void append(Outlines&& part, Outlines& all) {
    if (all.points.empty()) {
      all = std::move(part);
      return;
    }
    const std::size_t before = all.points.size();
    check_count(before + part.points.size(), "vertices of outlines", most_vertices);
    all.points.insert(all.points.end(), part.points.begin(), part.points.end());
    for (const std::uint32_t end : part.contour_ends)
      all.contour_ends.push_back(static_cast<std::uint32_t>(before + end));
    all.corners += part.corners;
    all.folded_pieces += part.folded_pieces;
    part = {};
  }

  const ShapeView& shapes_;
  double distance_;
  const BufferOptions& options_;
  Control& control_;
};

}  // namespace

PipelineResult zone_of(const ShapeView& shapes, double distance, const BufferOptions& options, Control& control,
                       BufferStatistics& statistics) {
  return Zone(shapes, distance, options, control).run(statistics);
}

}  // namespace oblast::internal::buffering
