// A second chance for trace vertices that came back because two straightened edges were in each other's way: one of
// the two may go.
#pragma once

#include "overlay/rings.h"

namespace oblast {

/// Takes restored vertices out one by one, the lexicographically smallest first, until none can go without the rest
/// of the result being met. Cost: O(n log n), and for each vertex tried the edges of all stretches near its own: up to
/// quadratic in the vertices that one input edge got back.
Rings retry_traces(Rings rings);

}  // namespace oblast
