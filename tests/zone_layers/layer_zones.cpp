#include "zone_layers/layer_zones.h"

#include <oblast/zones.h>

#include <algorithm>

#include "io/read.h"
#include "verify/box_tree.h"
#include "verify/zones.h"

namespace oblast::testing {
namespace {

/// Every feature is an object.
struct LayerObjects {
  io::Layer layer;
  std::vector<std::uint32_t> region_rows;

  explicit LayerObjects(const std::string& path)
      : layer(io::read(std::vector{path}, {.other = io::OtherGeometry::keep, .entries = io::FeatureEntries::all})) {
    const std::size_t polygons = layer.regions.view().polygon_count(), features = layer.features.size();
    for (std::uint32_t f = 0; f < features; ++f)
      region_rows.resize(f + 1 < features ? layer.features[f + 1].first_polygon : polygons, f);
  }

  ShapeFeatures view() const {
    const io::LinesAndPoints& others = layer.others;
    return {{layer.regions, {others.line_vertices, others.line_ends}, others.points},
            region_rows,
            others.line_features,
            others.point_features};
  }
  std::uint64_t vertices() const {
    return layer.regions.points.size() + layer.others.line_vertices.size() + layer.others.points.size();
  }
  /// The box of all with a margin of a tenth.
  RegionSet frame() const {
    verify::Box box;
    for (const auto* points : {&layer.regions.points, &layer.others.line_vertices, &layer.others.points})
      for (const Point& p : *points) box.add({p, p});
    const double margin = std::max(box.high.x - box.low.x, box.high.y - box.low.y) / 10;
    const double x0 = box.low.x - margin, y0 = box.low.y - margin, x1 = box.high.x + margin, y1 = box.high.y + margin;
    return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {4}, {1}};
  }
};

}  // namespace

LayerFigures judge_layer(const std::string& path, const LayerTrial& trial) {
  const LayerObjects shapes(path);
  const RegionSet frame = shapes.frame();
  ZoneStatistics statistics;
  ZoneOptions options;
  options.relative_tolerance = trial.relative_tolerance;
  options.statistics = &statistics;
  const FeatureSet rows = zones(shapes.view(), frame, options);

  LayerFigures figures;
  figures.objects = rows.size();
  figures.vertices = shapes.vertices();
  figures.sites = statistics.sites;
  figures.tolerance = statistics.tolerance;
  figures.error = statistics.error;
  figures.rounding = statistics.rounding;
  if (statistics.error > statistics.tolerance) figures.fault = "the error is above the tolerance";

  const verify::ZoneObjects objects(shapes.view());
  const verify::JudgedZones judged{objects, frame, rows, rows.keys};
  verify::ZoneCoverMeasures cover;
  if (const auto fault = verify::check_zone_cover(judged, {statistics.rounding, true}, &cover))
    figures.fault = "Z1 or Z2: " + fault->what;
  verify::ZoneDistanceBounds bounds;
  bounds.epsilon = statistics.error + statistics.rounding;
  bounds.moved = statistics.rounding;
  bounds.places = trial.places;
  bounds.seed = trial.seed;
  verify::ZoneDistanceMeasures distances;
  if (const auto fault = verify::check_zone_distances(judged, bounds, &distances); fault && figures.fault.empty())
    figures.fault = "Z3: " + fault->what;
  figures.seen = distances.epsilon;
  figures.places = distances.places;
  figures.exactly = distances.exactly;
  figures.excused = cover.excused + distances.excused;
  return figures;
}

}  // namespace oblast::testing
