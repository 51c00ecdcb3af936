// A second chance for trace vertices that came back because two straightened edges were in each other's way: one of
// the two may go.
#pragma once

#include "overlay/rings.h"

namespace oblast {

/// Takes restored vertices out one by one, the lexicographically smallest first, until none can go without the rest
/// of the result being met. Cost: O(n log n + k log k), k restored vertices and pairs of what is near them.
Rings retry_traces(Rings rings);

}  // namespace oblast
