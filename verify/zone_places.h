// Where zones are tested.
#pragma once

#include <cstdint>
#include <vector>

#include "verify/zones.h"

namespace oblast::verify {

/// `count` places at random in the box of the frame, and about as many at ends and middles of edges of rows, elsewhere
/// on them, and up to 4 units in the last place beside these. All edges are visited if `count` is six times their
/// number.
std::vector<Point> zone_places(const JudgedZones& zones, std::uint64_t count, std::uint64_t seed);

}  // namespace oblast::verify
