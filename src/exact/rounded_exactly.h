// An exact rational number rounded to the nearest double of the domain.
#pragma once

#include <oblast/domain.h>

#include <cmath>
#include <limits>

#include "exact/expansion.h"

namespace oblast::internal::exact {

/// The next coordinate of the domain above x (below: negate twice).
inline double next_up(double x) {
  if (x >= 0 && x < domain_smallest) return domain_smallest;
  if (x < 0 && x >= -domain_smallest) return 0;
  return std::nextafter(x, std::numeric_limits<double>::infinity());
}

/// The exact rational numerator / denominator, denominator > 0, against the midpoint of p and q.
template <int N, int M>
int compare_with_midpoint(const Expansion<N>& numerator, const Expansion<M>& denominator, double p, double q) {
  double x, y;
  two_sum(p / 2, q / 2, x, y);
  Expansion<2> midpoint;
  midpoint.push(y);
  midpoint.push(x);
  return (numerator - denominator * midpoint).sign();
}

inline bool is_even(double x) {
  int exponent;
  return std::fmod(std::ldexp(std::frexp(x, &exponent), 53), 2.0) == 0;
}

/// The exact rational numerator / denominator rounded to nearest, ties to even; a magnitude below the domain becomes 0
/// or domain_smallest, whichever is nearer. REQUIRES: denominator > 0.
template <int N, int M>
double rounded_exactly(const Expansion<N>& numerator, const Expansion<M>& denominator) {
  double x = numerator.estimate() / denominator.estimate();
  if (std::fabs(x) < domain_smallest) x = 0;
  for (;;) {
    const double above = next_up(x), below = -next_up(-x);
    const int up = compare_with_midpoint(numerator, denominator, x, above);
    if (up > 0 || (up == 0 && !is_even(x))) {
      x = above;
      if (up == 0) return x;
      continue;
    }
    const int down = compare_with_midpoint(numerator, denominator, x, below);
    if (down < 0 || (down == 0 && !is_even(x))) {
      x = below;
      if (down == 0) return x;
      continue;
    }
    return x == 0 ? 0.0 : x;
  }
}

}  // namespace oblast::internal::exact
