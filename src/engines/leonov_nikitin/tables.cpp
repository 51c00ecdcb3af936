// The proof that Tables 2 and 3 follow from the truth table of stage 4. The compiler checks every entry.
// The minimal neighbourhoods of an edge (the paper's Table 1) say which regions contain its two sides.
#include "engines/leonov_nikitin/tables.h"

#include "result/select.h"

namespace oblast::internal::leonov_nikitin {
namespace {

struct Sides {
  bool left, right;
};

constexpr Sides in_own = {true, false};

constexpr Sides in_other(EdgeLabel label) {
  switch (label) {
    case EdgeLabel::outside:
      return {false, false};
    case EdgeLabel::inside:
      return {true, true};
    case EdgeLabel::shared1:
      return in_own;
    case EdgeLabel::shared2:
      return {in_own.right, in_own.left};
  }
  return {};
}

/// Stage 4: the result must be on exactly one side of the edge; the edge is directed so that this is the left side.
constexpr Direction by_truth_table(Operation op, EdgeLabel label, Region of) {
  const Sides other = in_other(label);
  const Sides a = of == Region::a ? in_own : other, b = of == Region::a ? other : in_own;
  const bool left = admits(op, a.left, b.left), right = admits(op, a.right, b.right);
  if (left == right) return Direction::none;
  return left ? Direction::forward : Direction::backward;
}

constexpr Operation operations[] = {Operation::intersection, Operation::unite, Operation::difference,
                                    Operation::symmetric_difference};
constexpr Region regions[] = {Region::a, Region::b};
constexpr EdgeLabel edge_labels[] = {EdgeLabel::outside, EdgeLabel::inside, EdgeLabel::shared1, EdgeLabel::shared2};

constexpr bool table_2_follows() {
  for (const Operation op : operations)
    for (const Region of : regions)
      if (contour_rule(op, ContourLabel::outside, of) != by_truth_table(op, EdgeLabel::outside, of) ||
          contour_rule(op, ContourLabel::inside, of) != by_truth_table(op, EdgeLabel::inside, of))
        return false;
  return true;
}

constexpr bool table_3_follows() {
  for (const Operation op : operations)
    for (const Region of : regions)
      for (const EdgeLabel label : edge_labels)
        if (edge_rule(op, label, of) != by_truth_table(op, label, of)) return false;
  return true;
}

static_assert(table_2_follows());
static_assert(table_3_follows());

}  // namespace
}  // namespace oblast::internal::leonov_nikitin
