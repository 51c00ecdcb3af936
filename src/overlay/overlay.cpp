#include <oblast/overlay.h>

#include <algorithm>

#include "base/parallel.h"
#include "base/tuning.h"
#include "classics/window/fast_path.h"
#include "memory/call_memory.h"
#include "noding/largest_ulp.h"
#include "overlay/pipeline.h"
#include "overlay/validate.h"

namespace oblast {
namespace {

void check_options(const Options& options) {
  for (const FillRule* rule : {&options.fill_a, &options.fill_b})
    if (rule->kind == FillRule::Kind::at_least && rule->depth < 1)
      throw Error(ErrorCode::bad_option, "at_least needs a depth of 1 or more");
  if (options.threads < 0) throw Error(ErrorCode::bad_option, "threads must be 0 (all cores) or more");
}

void report(const RegionView& a, const RegionView* b, const RegionSet& result, Statistics& statistics) {
  statistics.input_contours = a.contour_count() + (b ? b->contour_count() : 0);
  statistics.input_vertices = a.points.size() + (b ? b->points.size() : 0);
  statistics.output_polygons = result.polygon_ends.size();
  statistics.output_contours = result.contour_ends.size();
  statistics.output_vertices = result.points.size();
  if (statistics.largest_displacement > 0)
    statistics.largest_displacement_ulps =
        statistics.largest_displacement /
        noding::ulp_of(std::max(noding::largest_coordinate(a.points), b ? noding::largest_coordinate(b->points) : 0));
}

RegionSet run_in_call(const RegionView& a, const RegionView* b, Operation operation, const Options& options,
                      Control& control) {
  validate(a, 0);
  if (b) validate(*b, 1);
  const std::size_t vertices = a.points.size() + (b ? b->points.size() : 0);
  if (vertices >= 0x7fffffff) throw Error(ErrorCode::too_large, "more than 2^31 - 1 vertices in one call");
  if (b)
    if (std::optional<RegionSet> result = classics::fast_overlay(a, *b, operation, options)) return *std::move(result);

  Statistics statistics;
  PipelineResult result = run_pipeline(a, b, operation, options, control, statistics);
  if (options.statistics) {
    report(a, b, result.regions, statistics);
    *options.statistics = statistics;
  }
  return std::move(result.regions);
}

RegionSet run(const RegionView& a, const RegionView* b, Operation operation, const Options& options) {
  check_options(options);
  Control control(options);
  Call call;
  call.control = &control;
  const std::size_t vertices = a.points.size() + (b ? b->points.size() : 0);
  if (vertices <= tuning::small_call) {
    // In memory of its own, on this thread.
    CallMemory memory;
    call.memory = &memory;
    const WorkingFor working(call);
    RegionSet result = run_in_call(a, b, operation, options, control);
    control.finish();
    return result;
  }
  call.blocks = kept_blocks(options.workspace, vertices);
  RegionSet result;
  run_call(call, options.threads, [&] {
    {
      const Share whole(control);
      result = run_in_call(a, b, operation, options, control);
    }
    control.finish();
  });
  return result;
}

}  // namespace

RegionSet overlay(const RegionView& a, const RegionView& b, Operation operation, const Options& options) {
  return run(a, &b, operation, options);
}

RegionSet unite(const RegionView& regions, const Options& options) {
  return run(regions, nullptr, Operation::unite, options);
}

}  // namespace oblast
