// Making a failing case small enough to read.
#pragma once

#include <functional>
#include <string>

#include "generators/hostile.h"

namespace oblast::generators {

/// Drops polygons, contours and vertices for as long as `fails` stays true of what is left.
/// Cost: at most `budget` calls of `fails`. REQUIRES: fails(operands).
Operands shrink(Operands operands, const std::function<bool(const Operands&)>& fails, int budget = 3000);

/// MULTIPOLYGON of the soup as it is (rings closed by repeating their first vertex), shortest digits
/// that read back to the same bits. Needs no GDAL.
std::string soup_to_wkt(const RegionView& soup);

}  // namespace oblast::generators
