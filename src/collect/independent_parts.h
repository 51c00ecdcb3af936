// Independent parts: strands that cannot meet those of another part, because no box of one touches a box
// of another.
//
//   +----+        +--+         Three strands, two parts: the boxes of the first two meet. Whatever noding does to
//   |  +-|--+     |  |         a piece of an edge, it stays in the edge's box, so each part can be overlaid by
//   +--|-+  |     +--+         itself, and no contour of one encloses one of another.
//      +----+
//
// A layer of many small contours falls into thousands of parts. Taken a few at a time they fit a processor's
// cache, keep all cores busy without waiting for each other, and need little memory at once.
#pragma once

#include <cstdint>

#include "base/call_memory.h"
#include "noding/strands.h"

namespace oblast::internal {

struct IndependentParts {
  Array<std::uint32_t> strands;  ///< batch by batch; of a batch in an order that keeps neighbours together
  Array<std::uint32_t> ends;     ///< by batch: past its last strand. A batch is one large part or several small

  std::size_t size() const { return ends.size(); }
};

/// What a part must hold to matter.
struct PartNeeds {
  bool a = false;
  bool b = false;
};

/// False for a small call, and for one strand.
bool worth_dividing(const noding::Strands& strands);

/// Batches of parts. One batch of all strands where dividing would not pay; otherwise parts without an operand they
/// need are left out. Parts may be larger than they have to be, never smaller. Cost: O(n log n) at most; memory
/// O(strands).
IndependentParts independent_parts(const noding::Strands& strands, PartNeeds needs);

/// The strands of one batch.
noding::Strands batch_of(const noding::Strands& strands, const IndependentParts& parts, std::size_t batch);

/// The same for the caller's own strands, which are moved together instead of copied, in the order in which they stand.
noding::Strands only_batch(noding::Strands strands, const IndependentParts& parts, std::size_t batch);

}  // namespace oblast::internal
