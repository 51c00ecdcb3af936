// Runs stages 2 to 6 on independent parts of the input, in parallel on all cores.
#pragma once

#include <functional>

#include "base/control.h"
#include "collect/independent_parts.h"
#include "noding/strands.h"

namespace oblast::internal {

/// What is done with the batches of a call.
struct BatchWork {
  /// Told first how many batches there are.
  std::function<void(std::size_t count)> begin;
  /// Stages 2 to 6 on the strands of one batch. Several run side by side.
  std::function<void(std::size_t batch, noding::Strands strands, Statistics& statistics)> run;
};

/// Divides the strands into batches and does the work on each. A small input, and one that does not fall into parts, is
/// one batch; where parts lack an operand that they need, there may be none.
void in_batches(noding::Strands strands, PartNeeds needs, Control& control, Statistics& statistics,
                const BatchWork& work);

}  // namespace oblast::internal
