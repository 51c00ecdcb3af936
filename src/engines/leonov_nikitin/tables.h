// Tables 2 and 3 of Leonov and Nikitin, as in the paper: which contours and which edges enter the result, and in which
// direction. E is an edge of one region, M is the other region:
//
//     OUTSIDE        INSIDE        SHARED1       SHARED2
//      : E :       M : E : M        : E :       M : E :       E runs upwards; its own region is on its left
//      : | :         : | :        M : | :         : | : M     (drawn as the colons); M is as marked
//
// The pipeline does not use these tables. Its labels are winding numbers left and right of a chain, and stage 4
// (result/select.h) applies the truth table of the operation to both. If the tables apply, that is the same rule;
// tables.cpp proves this for every entry. It also works if the tables do not apply: for operands that overlap
// themselves, and for any fill rule.
#pragma once

#include <oblast/options.h>

namespace oblast::internal::leonov_nikitin {

enum class Region { a, b };
enum class EdgeLabel { outside, inside, shared1, shared2 };
enum class ContourLabel { outside, inside, isected };
enum class Direction { none, forward, backward };  ///< none: not in the result

/// Table 2. REQUIRES: the label is not isected. A contour with that label is collected edge by edge.
constexpr Direction contour_rule(Operation op, ContourLabel flags, Region of) {
  const bool inside = flags == ContourLabel::inside, outside = flags == ContourLabel::outside;
  switch (op) {
    case Operation::intersection:
      return inside ? Direction::forward : Direction::none;
    case Operation::unite:
      return outside ? Direction::forward : Direction::none;
    case Operation::difference:
      if (outside && of == Region::a) return Direction::forward;
      if (inside && of == Region::b) return Direction::backward;
      return Direction::none;
    case Operation::symmetric_difference:
      return outside ? Direction::forward : inside ? Direction::backward : Direction::none;
  }
  return Direction::none;
}

/// Table 3, the paper's EdgeRule. If both of two coincident edges are admitted, one of them enters the result.
constexpr Direction edge_rule(Operation op, EdgeLabel flags, Region of) {
  const bool inside = flags == EdgeLabel::inside, outside = flags == EdgeLabel::outside;
  const bool shared1 = flags == EdgeLabel::shared1, shared2 = flags == EdgeLabel::shared2;
  switch (op) {
    case Operation::intersection:
      return inside || shared1 ? Direction::forward : Direction::none;
    case Operation::unite:
      return outside || shared1 ? Direction::forward : Direction::none;
    case Operation::difference:
      if ((outside || shared2) && of == Region::a) return Direction::forward;
      if ((inside || shared2) && of == Region::b) return Direction::backward;
      return Direction::none;
    case Operation::symmetric_difference:
      return outside ? Direction::forward : inside ? Direction::backward : Direction::none;
  }
  return Direction::none;
}

}  // namespace oblast::internal::leonov_nikitin
