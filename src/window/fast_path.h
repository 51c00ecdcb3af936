// What `overlay` need not do: operands of which one is convex and small.
#pragma once

#include <oblast/options.h>
#include <oblast/region_set.h>

#include <optional>

namespace oblast::internal::window {

/// The result of `overlay`, byte for byte, where the operands have a form that is recognised at small cost and in
/// general position (window_clip.h): any subject and a convex window of at most 64 sides, intersection; two such
/// convex contours, union and difference. Nothing otherwise, and where the options ask for anything but the
/// defaults. The result has the arrays of `spare`, which is left alone in most cases where there is none.
/// REQUIRES: both validated.
std::optional<RegionSet> fast_overlay(const RegionView& a, const RegionView& b, Operation operation,
                                      const Options& options, RegionSet* spare = nullptr);

}  // namespace oblast::internal::window
