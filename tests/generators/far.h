// A case with others far away.
#pragma once

#include <cstdint>

#include "generators/company.h"

namespace oblast::generators {

/// Operands with small squares beside them; no box of a square meets the box of a polygon of the operands.
/// Squares stand in rows on all four sides, some repeated, some overlapping; some lie in gaps between the polygons;
/// some lie so far away that the unit in the last place of the whole input is many times larger. Mostly some dozens,
/// now and then some thousands.
struct FarSquares {
  RegionSet a, b;
};
FarSquares far_squares(const Operands& operands, std::uint64_t seed);

/// The operands with the squares, in an order of their own.
Operands with_squares(const Operands& operands, const FarSquares& squares, std::uint64_t seed);

}  // namespace oblast::generators
