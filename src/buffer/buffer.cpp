#include <oblast/buffer.h>
#include <oblast/domain.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/check_options.h"
#include "base/public_call.h"
#include "base/stage_shares.h"
#include "buffer/row_shapes.h"
#include "buffer/zone.h"
#include "regions/join_features.h"
#include "regions/validate.h"

namespace oblast {
using namespace internal;
using namespace internal::buffering;
namespace {

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorCode::bad_option, what); }

void check_buffer_options(const BufferOptions& options) {
  check_fill_rule(options.fill);
  check_enumerator(options.join, Join::bevel, "Join");
  check_enumerator(options.cap, Cap::square, "Cap");
  check_enumerator(options.side, Side::right, "Side");
  check_enumerator(options.mode, BufferMode::outside, "BufferMode");
  if (!(options.mitre_limit >= 1 && std::isfinite(options.mitre_limit)))
    refuse("mitre_limit is " + std::to_string(options.mitre_limit) + "; it must be 1 or more");
  if (!(options.tolerance >= 1e-9 && options.tolerance <= 0.5))
    refuse("tolerance is " + std::to_string(options.tolerance) + "; it must be from 1e-9 to 0.5");
  if (!(options.absolute_tolerance >= 0 && std::isfinite(options.absolute_tolerance)))
    refuse("absolute_tolerance is " + std::to_string(options.absolute_tolerance) + "; it must be 0 or more");
}

void check_distance(double distance, const std::string& which = {}) {
  if (!std::isfinite(distance)) refuse("the distance" + which + " is not a finite number");
  if (distance != 0 && !in_domain(distance))
    refuse("the distance" + which + " is " + std::to_string(distance) + ", which is not in the domain of coordinates");
}

void check_shapes(const ShapeView& shapes) {
  validate(shapes.regions, 0);
  validate(RegionView{shapes.lines.points, shapes.lines.line_ends, {}}, 1);
  const std::uint32_t all_points[] = {checked_index(shapes.points.size(), "points in one call", most_vertices)};
  validate(RegionView{shapes.points, std::span(all_points).first(shapes.points.empty() ? 0 : 1), {}}, 2);
}

std::size_t vertices_of(const ShapeView& shapes) {
  return shapes.regions.points.size() + shapes.lines.points.size() + shapes.points.size();
}

void add(const BufferStatistics& row, BufferStatistics& all) {
  all.directions = std::max(all.directions, row.directions);
  all.corners += row.corners;
  all.closed_pockets += row.closed_pockets;
  all.folded_pieces += row.folded_pieces;
  all.lower_factor = std::min(all.lower_factor, row.lower_factor);
  all.upper_factor = std::max(all.upper_factor, row.upper_factor);
  all.rounding = std::max(all.rounding, row.rounding);
  Statistics& overlay = all.overlay;
  overlay.input_contours += row.overlay.input_contours;
  overlay.input_vertices += row.overlay.input_vertices;
  overlay.output_polygons += row.overlay.output_polygons;
  overlay.output_contours += row.overlay.output_contours;
  overlay.output_vertices += row.overlay.output_vertices;
  overlay.resolved_polygons += row.overlay.resolved_polygons;
  overlay.intersections += row.overlay.intersections;
  overlay.rounds = std::max(overlay.rounds, row.overlay.rounds);
  overlay.largest_displacement = std::max(overlay.largest_displacement, row.overlay.largest_displacement);
  overlay.largest_displacement_ulps =
      std::max(overlay.largest_displacement_ulps, row.overlay.largest_displacement_ulps);
  for (int stage = 0; stage < stage_count; ++stage) overlay.seconds[stage] += row.overlay.seconds[stage];
}

FeatureSet zones_of_rows(const ShapeFeatures& features, std::span<const double> distances, const BufferOptions& options,
                         Control& control) {
  const RowShapes rows(features, distances.size());
  const std::size_t count = distances.size(), vertices = vertices_of(features.shapes);
  struct Row {
    PipelineResult zone;
    BufferStatistics statistics;
  };
  Array<Row> zones(count);
  {
    Share* const whole = Share::current();
    const NoShare by_vertices;
    for_ranges(count, grain(count, vertices), [&](std::size_t f, std::size_t end) {
      for (; f < end; ++f) {
        poll();
        const RowShapes::Row row = rows.row(f);
        const double part = static_cast<double>(vertices_of(row.view())) / static_cast<double>(vertices + 1);
        const Share share(whole, buffer_rows_share * part);
        zones[f].zone = zone_of(row.view(), distances[f], options, control, zones[f].statistics);
      }
    });
  }
  Array<RegionView> parts;
  for (const Row& row : zones) parts.push_back(row.zone.regions);
  if (options.statistics) {
    *options.statistics = {};
    for (const Row& row : zones) add(row.statistics, *options.statistics);
  }
  return join_features(parts).features;
}

}  // namespace

RegionSet buffer(const ShapeView& shapes, double distance, const BufferOptions& options) {
  check_buffer_options(options);
  check_distance(distance);
  return public_call(options, options.statistics != nullptr, vertices_of(shapes), [&](Control& control) {
    check_shapes(shapes);
    BufferStatistics statistics;
    PipelineResult zone = zone_of(shapes, distance, options, control, statistics);
    if (options.statistics) *options.statistics = statistics;
    return std::move(zone.regions);
  });
}

FeatureSet buffer_rows(const ShapeFeatures& features, std::span<const double> distances, const BufferOptions& options) {
  check_buffer_options(options);
  for (std::size_t f = 0; f < distances.size(); ++f) check_distance(distances[f], " of row " + std::to_string(f));
  return public_call(options, options.statistics != nullptr, vertices_of(features.shapes), [&](Control& control) {
    check_shapes(features.shapes);
    return zones_of_rows(features, distances, options, control);
  });
}

}  // namespace oblast
