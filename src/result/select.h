// Stage 4: selects the chains that belong to the result, with the truth table of the operation.
#pragma once

#include <oblast/options.h>

#include "base/call_memory.h"
#include "graph/chain_graph.h"

namespace oblast::internal {

/// For each chain: the descriptor that has the result on its left, or `none` if the chain does not belong to the
/// result.
using Selection = LargeArray<Descriptor>;

/// Whether a point with this winding number is inside the operand.
constexpr bool is_inside(const FillRule& rule, std::int32_t winding) {
  switch (rule.kind) {
    case FillRule::Kind::polygons:
      return winding > 0;
    case FillRule::Kind::at_least:
      return winding >= rule.depth;
    case FillRule::Kind::even_odd:
      return (winding & 1) != 0;
    case FillRule::Kind::nonzero:
      return winding != 0;
    case FillRule::Kind::positive:
      return winding > 0;
    case FillRule::Kind::negative:
      return winding < 0;
  }
  return false;
}

/// The truth table over (inside A, inside B).
constexpr bool admits(Operation operation, bool in_a, bool in_b) {
  switch (operation) {
    case Operation::intersection:
      return in_a && in_b;
    case Operation::unite:
      return in_a || in_b;
    case Operation::difference:
      return in_a && !in_b;
    case Operation::symmetric_difference:
      return in_a != in_b;
  }
  return false;
}

/// A chain belongs to the result if exactly one of its sides is inside the result. `none` for chains that are not live.
Selection select(const ChainGraph& graph, const LargeArray<Winding>& right, Operation operation,
                 const Options& options);

}  // namespace oblast::internal
