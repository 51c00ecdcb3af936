// Stage 1: converts the contours of both operands to strands of edges.
//
// Degenerate contours are dropped. Under a fill rule that uses polygons one by one, each polygon must have winding
// number 1 in its region and 0 elsewhere. If its edges do not meet, which plane/ring_tree.h finds out at little cost,
// the depth of each ring in the others decides its direction. (Its winding change is set; its points are not reversed.)
// Otherwise the polygon is resolved first, separately (noding/resolve.h). Two kinds of rings are only assumed to be
// simple (node_strands.h): the ring of an operand of one ring, unless it is convex, and a ring that winds too much for
// the test.
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

/// Adds the number of polygons whose rings meet to `resolved_polygons`. Throws Error: too_large. REQUIRES: the operands
/// are valid (regions/validate.h).
noding::Strands collect(std::span<const Operand> operands, const Resolve& resolve, std::uint64_t& resolved_polygons);

/// The operands of an overlay of two region sets. `b` may be null. Throws Error: too_large.
inline noding::Strands collect(const RegionView& a, const RegionView* b, const Options& options, const Resolve& resolve,
                               std::uint64_t& resolved_polygons) {
  const Operand operands[] = {{a, false, options.fill_a}, {b ? *b : a, true, options.fill_b}};
  return collect(std::span(operands).first(b ? 2 : 1), resolve, resolved_polygons);
}

}  // namespace oblast::internal
