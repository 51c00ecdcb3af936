// A case with others far away.
#pragma once

#include <cstdint>

#include "generators/company.h"

namespace oblast::generators {

/// Small squares beside operands. No box of a square meets the box of a polygon of the operands. Squares are in rows on
/// all four sides; some are repeated, some overlap. Some are in gaps between the polygons. Some are so far away that
/// the unit in the last place of the whole input is many times larger. Usually some dozens, sometimes some thousands.
struct FarSquares {
  RegionSet a, b;
};
FarSquares far_squares(const Operands& operands, std::uint64_t seed);

/// The operands with the squares, in a random order.
Operands with_squares(const Operands& operands, const FarSquares& squares, std::uint64_t seed);

}  // namespace oblast::generators
