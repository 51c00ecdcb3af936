// Stage 1: the contours of both operands to strands of edges.
//
// Degenerate contours are dropped, bad coordinates refused. Under a rule that reads polygons one by one each
// polygon must enter with winding number 1 on its region and 0 elsewhere. Where its edges do not meet, which
// plane/ring_tree.h tells for next to nothing, each ring is turned as its depth in the others asks (its winding change
// is, the points stay where they are); otherwise the polygon is resolved by itself first (noding/resolve.h). The one
// ring of an operand of one polygon is only assumed to be simple where it is not convex, and so is a ring that wanders
// about too much to tell (node_strands.h).
#pragma once

#include <oblast/options.h>
#include <oblast/region_set.h>

#include <cstdint>
#include <span>

#include "noding/resolve.h"
#include "noding/strands.h"

namespace oblast::internal {

/// What is collected, and how its contours change the winding numbers.
struct Operand {
  const RegionView& regions;
  bool is_b;
  FillRule rule;
  /// By polygon, where rows are overlaid: which source it belongs to (noding/source_changes.h). Empty: changes are
  /// winding numbers. Not empty only under a rule that reads polygons one by one.
  std::span<const std::uint32_t> sources = {};
};

/// `resolved_polygons` grows by those whose rings were found to meet. Throws Error: too_large.
noding::Strands collect(std::span<const Operand> operands, const Resolve& resolve, std::uint64_t& resolved_polygons);

/// The operands of an overlay of two region sets. `b` may be null. Throws Error: too_large.
inline noding::Strands collect(const RegionView& a, const RegionView* b, const Options& options, const Resolve& resolve,
                               std::uint64_t& resolved_polygons) {
  const Operand operands[] = {{a, false, options.fill_a}, {b ? *b : a, true, options.fill_b}};
  return collect(std::span(operands).first(b ? 2 : 1), resolve, resolved_polygons);
}

}  // namespace oblast::internal
