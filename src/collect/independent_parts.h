// Independent parts: strands of one part cannot meet strands of another part, because no box of one touches a box of
// the other.
//
//   +----+        +--+         Three strands, two parts: the boxes of the first two meet. Noding keeps each piece
//   |  +-|--+     |  |         of an edge in the box of the edge. So each part can be overlaid separately, and no
//   +--|-+  |     +--+         contour of one part encloses a contour of another.
//      +----+
//
// A layer of many small contours has thousands of parts. A few at a time fit a processor's cache and need little
// memory, and all cores can work without waiting for each other.
#pragma once

#include <cstdint>

#include "base/call_memory.h"
#include "noding/strands.h"

namespace oblast::internal {

struct IndependentParts {
  Array<std::uint32_t> strands;  ///< by batch; in a batch, neighbours are close to each other
  Array<std::uint32_t> ends;     ///< by batch: the end of its strands. A batch is one large part or several small parts

  std::size_t size() const { return ends.size(); }
};

/// The operands that a part must contain to have a result.
struct PartNeeds {
  bool a = false;
  bool b = false;
};

/// False for a small call, and for one strand.
bool worth_dividing(const noding::Strands& strands);

/// The batches of parts. If dividing would not save time, one batch of all strands. Otherwise parts without an operand
/// that they need are left out. Parts may be larger than necessary, but never smaller. Cost: at most O(n log n) time,
/// O(strands) memory.
IndependentParts independent_parts(const noding::Strands& strands, PartNeeds needs);

/// The strands of one batch.
noding::Strands batch_of(const noding::Strands& strands, const IndependentParts& parts, std::size_t batch);

/// The same, but reuses the arrays of `strands`: its strands are moved together, in their order, and not copied.
noding::Strands only_batch(noding::Strands strands, const IndependentParts& parts, std::size_t batch);

}  // namespace oblast::internal
