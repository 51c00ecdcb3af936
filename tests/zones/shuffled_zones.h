// The same objects written in another order.
#pragma once

#include "zones/zone_trial.h"

namespace oblast::testing {

/// Shapes in another order, each with its object; lines and rings turned, rings from another vertex on. If every shape
/// is an object, only lines and rings are turned.
ZoneQuestion shuffled(const ZoneQuestion& question, std::uint64_t seed);

}  // namespace oblast::testing
