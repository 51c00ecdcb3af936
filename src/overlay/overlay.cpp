#include <oblast/overlay.h>

#include <algorithm>
#include <functional>

#include "base/check_options.h"
#include "base/public_call.h"
#include "overlay/pipeline.h"
#include "overlay/report.h"
#include "regions/validate.h"
#include "window/fast_path.h"

namespace oblast {
using namespace internal;
namespace {

RegionSet run_in_call(const RegionView& a, const RegionView* b, Operation operation, const Options& options,
                      Control& control, RegionSet* spare) {
  validate(a, 0);
  if (b) validate(*b, 1);
  if (b)
    if (std::optional<RegionSet> result = window::fast_overlay(a, *b, operation, options, spare))
      return *std::move(result);

  Statistics statistics;
  PipelineResult result =
      run_pipeline(a, b, {operation, options, control}, statistics, spare ? std::move(*spare) : RegionSet{});
  if (options.statistics) {
    const RegionView operands[] = {a, b ? *b : RegionView{}};
    report(operands, result.regions, statistics);
    *options.statistics = statistics;
  }
  return std::move(result.regions);
}

/// Runs a call. The result reuses the arrays of `spare`, if it is given and they have room.
RegionSet run(const RegionView& a, const RegionView* b, Operation operation, const Options& options,
              RegionSet* spare = nullptr) {
  check_operation(operation);
  check_overlay_options(options);
  check_count(a.polygon_count() + (b ? b->polygon_count() : 0), "polygons in one call");
  const std::size_t vertices = a.points.size() + (b ? b->points.size() : 0);
  return public_call(options, options.statistics != nullptr, vertices,
                     [&](Control& control) { return run_in_call(a, b, operation, options, control, spare); });
}

bool is_in(const void* item, const auto& items) {
  const std::less<> before;
  return !before(item, items.data()) && before(item, items.data() + items.size());
}

/// True if the view is a view of the set, or of a part of it.
bool is_view_of(const RegionView& view, const RegionSet& set) {
  return is_in(view.points.data(), set.points) || is_in(view.contour_ends.data(), set.contour_ends) ||
         is_in(view.polygon_ends.data(), set.polygon_ends);
}

void run_into(const RegionView& a, const RegionView* b, Operation operation, const Options& options,
              RegionSet& result) {
  const bool is_read = is_view_of(a, result) || (b && is_view_of(*b, result));
  RegionSet spare;
  if (!is_read) spare = std::move(result);
  result = run(a, b, operation, options, &spare);
}

}  // namespace

RegionSet overlay(const RegionView& a, const RegionView& b, Operation operation, const Options& options) {
  return run(a, &b, operation, options);
}

void overlay(const RegionView& a, const RegionView& b, Operation operation, const Options& options, RegionSet& result) {
  run_into(a, &b, operation, options, result);
}

RegionSet unite(const RegionView& regions, const Options& options) {
  return run(regions, nullptr, Operation::unite, options);
}

void unite(const RegionView& regions, const Options& options, RegionSet& result) {
  run_into(regions, nullptr, Operation::unite, options, result);
}

}  // namespace oblast
