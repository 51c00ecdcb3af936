// A second chance for trace vertices that came back because two straightened edges were in each other's way: one of
// the two may go.
#pragma once

#include "overlay/rings.h"

namespace oblast {

/// Takes restored vertices out one by one until none can go without the rest of the result being met: the one with the
/// shortest edge in its place first, of equal ones the lexicographically smallest. Cost: O(n log n), where boxes of
/// edges tell what comes near them.
Rings retry_traces(Rings rings);

}  // namespace oblast
