#include <oblast/overlay.h>
#include <tbb/task_arena.h>

#include <algorithm>

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

/// A small call: in memory of its own, on the thread that it is made on.
template <class Work>
void in_call_memory(const Work& work) {
  const CallMemory memory;
  work();
}

template <class Work>
void on_threads(const Options& options, std::size_t vertices, const Work& work) {
  const auto large_call = [&] {
    const LargeCall large(kept_blocks(options.workspace, vertices));
    work();
  };
  if (options.threads == 0) {
    // A thread that waits for others of this call makes no other call's arrays meanwhile: they would be blocks of this
    // call's workspace, and might outlive it.
    tbb::this_task_arena::isolate(large_call);
  } else {
    tbb::task_arena arena(options.threads);
    arena.execute(large_call);
  }
}

RegionSet run(const RegionView& a, const RegionView* b, Operation operation, const Options& options) {
  check_options(options);
  validate(a, 0);
  if (b) validate(*b, 1);
  const std::size_t vertices = a.points.size() + (b ? b->points.size() : 0);
  if (vertices >= 0x7fffffff) throw Error(ErrorCode::too_large, "more than 2^31 - 1 vertices in one call");
  if (b)
    if (std::optional<RegionSet> result = classics::fast_overlay(a, *b, operation, options)) return *std::move(result);

  Statistics statistics;
  Control control(options);
  PipelineResult result;
  const auto work = [&] { result = run_pipeline(a, b, operation, options, control, statistics); };
  constexpr std::size_t small_call = 128;
  if (vertices <= small_call)
    in_call_memory(work);
  else
    on_threads(options, vertices, work);
  if (options.statistics) {
    statistics.input_contours = a.contour_count() + (b ? b->contour_count() : 0);
    statistics.input_vertices = vertices;
    statistics.output_polygons = result.regions.polygon_ends.size();
    statistics.output_contours = result.regions.contour_ends.size();
    statistics.output_vertices = result.regions.points.size();
    if (statistics.largest_displacement > 0)
      statistics.largest_displacement_ulps =
          statistics.largest_displacement /
          noding::ulp_of(std::max(noding::largest_coordinate(a.points), b ? noding::largest_coordinate(b->points) : 0));
    *options.statistics = statistics;
  }
  return std::move(result.regions);
}

}  // namespace

RegionSet overlay(const RegionView& a, const RegionView& b, Operation operation, const Options& options) {
  return run(a, &b, operation, options);
}

RegionSet unite(const RegionView& regions, const Options& options) {
  return run(regions, nullptr, Operation::unite, options);
}

}  // namespace oblast
