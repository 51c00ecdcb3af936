// Products of two expansions of any length, for predicates and constructions of degree 3 and more.
#pragma once

#include <algorithm>

#include "exact/expansion.h"

namespace oblast::internal::exact {

/// The exact product; components of the factors and of all partial sums are non-overlapping.
template <int N, int M>
Expansion<2 * N * M> product(const Expansion<N>& e, const Expansion<M>& f) {
  Expansion<2 * N * M> sum;
  for (int i = 0; i < f.size; ++i) {
    const auto next = sum + e * f.component[i];
    sum.size = next.size;
    std::copy_n(next.component, next.size, sum.component);
  }
  return sum;
}

}  // namespace oblast::internal::exact
