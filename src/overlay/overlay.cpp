#include <oblast/overlay.h>

#include <algorithm>

#include "base/check_options.h"
#include "base/public_call.h"
#include "overlay/pipeline.h"
#include "plane/largest_ulp.h"
#include "regions/validate.h"
#include "window/fast_path.h"

namespace oblast {
using namespace internal;
namespace {

void report(const RegionView& a, const RegionView* b, const RegionSet& result, Statistics& statistics) {
  statistics.input_contours = a.contour_count() + (b ? b->contour_count() : 0);
  statistics.input_vertices = a.points.size() + (b ? b->points.size() : 0);
  statistics.output_polygons = result.polygon_ends.size();
  statistics.output_contours = result.contour_ends.size();
  statistics.output_vertices = result.points.size();
  if (statistics.largest_displacement > 0)
    statistics.largest_displacement_ulps =
        statistics.largest_displacement /
        ulp_of(std::max(largest_coordinate(a.points), b ? largest_coordinate(b->points) : 0));
}

RegionSet run_in_call(const RegionView& a, const RegionView* b, Operation operation, const Options& options,
                      Control& control) {
  validate(a, 0);
  if (b) validate(*b, 1);
  if (b)
    if (std::optional<RegionSet> result = window::fast_overlay(a, *b, operation, options)) return *std::move(result);

  Statistics statistics;
  PipelineResult result = run_pipeline(a, b, {operation, options, control}, statistics);
  if (options.statistics) {
    report(a, b, result.regions, statistics);
    *options.statistics = statistics;
  }
  return std::move(result.regions);
}

RegionSet run(const RegionView& a, const RegionView* b, Operation operation, const Options& options) {
  check_operation(operation);
  check_overlay_options(options);
  check_count(a.polygon_count() + (b ? b->polygon_count() : 0), "polygons in one call");
  const std::size_t vertices = a.points.size() + (b ? b->points.size() : 0);
  return public_call(options, options.statistics != nullptr, vertices,
                     [&](Control& control) { return run_in_call(a, b, operation, options, control); });
}

}  // namespace

RegionSet overlay(const RegionView& a, const RegionView& b, Operation operation, const Options& options) {
  return run(a, &b, operation, options);
}

RegionSet unite(const RegionView& regions, const Options& options) {
  return run(regions, nullptr, Operation::unite, options);
}

}  // namespace oblast
