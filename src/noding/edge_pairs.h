// From pairs of runs to pairs of edges.
#pragma once

#include <bit>
#include <cstdint>

#include "noding/monotone_runs.h"
#include "noding/pair_finder.h"
#include "plane/box.h"
#include "plane/edges_in.h"

namespace oblast::internal::noding {

/// Calls test(i, j) for every edge i of one run and j of the other whose boxes meet; for all of two single edges.
/// First, without branches, the edges of each that reach into the box of the other are found: usually few.
template <class Test>
void for_edge_pairs(const Point* points, const RunPair& pair, const Test& test) {
  static_assert(longest_run <= 32);
  const auto box_of = [points](std::uint32_t first, std::uint32_t last) {  // of a run between two vertices
    return Box::of(points[first], points[last]);
  };
  const bool one_p = pair.last_p - pair.first_p == 1, one_q = pair.last_q - pair.first_q == 1;
  if (one_p && one_q) {
    test(pair.first_p, pair.first_q);
    return;
  }
  const std::uint32_t in_q = one_p ? 1 : edges_in(box_of(pair.first_q, pair.last_q), points, pair.first_p, pair.last_p);
  if (in_q == 0) return;
  const std::uint32_t in_p = one_q ? 1 : edges_in(box_of(pair.first_p, pair.last_p), points, pair.first_q, pair.last_q);
  const bool boxes_meet = one_p || one_q;
  for (std::uint32_t p = in_q; p != 0; p &= p - 1) {
    const std::uint32_t i = pair.first_p + static_cast<std::uint32_t>(std::countr_zero(p));
    for (std::uint32_t q = in_p; q != 0; q &= q - 1) {
      const std::uint32_t j = pair.first_q + static_cast<std::uint32_t>(std::countr_zero(q));
      if (boxes_meet || box_of(i, i + 1).meets(box_of(j, j + 1))) test(i, j);
    }
  }
}

}  // namespace oblast::internal::noding
