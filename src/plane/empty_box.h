// The box of nothing: it meets no box, and joined with another box it is that box.
#pragma once

#include <limits>

#include "plane/box.h"

namespace oblast::internal {

inline constexpr Box empty_box{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

}  // namespace oblast::internal
