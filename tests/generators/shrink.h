// Makes a failing case small enough to read.
#pragma once

#include <functional>

#include "generators/hostile.h"

namespace oblast::generators {

/// Drops polygons, contours and vertices while `fails` is true for the rest.
/// Cost: at most `budget` calls of `fails`. REQUIRES: fails(operands).
Operands shrink(Operands operands, const std::function<bool(const Operands&)>& fails, int budget = 3000);

}  // namespace oblast::generators
