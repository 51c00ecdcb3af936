// Expansion arithmetic: a real number as an exact, unevaluated sum of doubles.
//
// Reference: J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
// Predicates", 1997. Components are non-overlapping, in increasing order of magnitude, zeros left out.
//
// Why nothing overflows or underflows inside the domain (oblast/domain.h). A coordinate is 0 or has
// magnitude in [2^-300, 2^300], so it is a multiple of 2^-352. Differences are multiples of 2^-352
// below 2^301; products of two, multiples of 2^-704 below 2^603; of three, multiples of 2^-1056 below
// 2^906 (sums of a few of them included). Every component of an expansion is a multiple of the same
// unit as the number it stands for; the smallest unit, 2^-1057 with a halved coordinate, is above
// 2^-1074, so all error terms are representable, and splitting by 2^27 + 1 stays below 2^934.
//
// All of this needs every operation to be rounded on its own: floating-point contraction is off.
#pragma once

#include <cmath>

#include "base/arithmetic.h"

namespace oblast::internal::exact {

/// x + y == a + b exactly, x == round(a + b).
inline void two_sum(double a, double b, double& x, double& y) {
  x = a + b;
  const double b_virtual = x - a;
  const double a_virtual = x - b_virtual;
  y = (a - a_virtual) + (b - b_virtual);
}

/// As two_sum. REQUIRES: |a| >= |b| or a == 0.
inline void fast_two_sum(double a, double b, double& x, double& y) {
  x = a + b;
  y = b - (x - a);
}

/// x + y == a - b exactly, x == round(a - b).
inline void two_diff(double a, double b, double& x, double& y) { two_sum(a, -b, x, y); }

/// a == high + low exactly, each of at most 26 bits, so that products of halves are exact.
inline void split(double a, double& high, double& low) {
  const double c = 134217729.0 * a;  // 2^27 + 1
  high = c - (c - a);
  low = a - high;
}

/// x + y == a * b exactly, x == round(a * b).
inline void two_product(double a, double b, double& x, double& y) {
  x = a * b;
  double a_high, a_low, b_high, b_low;
  split(a, a_high, a_low);
  split(b, b_high, b_low);
  y = a_low * b_low - (((x - a_high * b_high) - a_low * b_high) - a_high * b_low);
}

/// An exact number of at most `Capacity` components.
template <int Capacity>
struct Expansion {
  double component[Capacity];
  int size = 0;

  void push(double c) {
    if (c != 0) component[size++] = c;
  }
  /// The sign of an expansion is the sign of its largest component.
  int sign() const {
    if (size == 0) return 0;
    return component[size - 1] > 0 ? 1 : -1;
  }
  /// Within one unit in the last place of the number.
  double estimate() const {
    double sum = 0;
    for (int i = 0; i < size; ++i) sum += component[i];
    return sum;
  }
  Expansion operator-() const {
    Expansion r;
    r.size = size;
    for (int i = 0; i < size; ++i) r.component[i] = -component[i];
    return r;
  }
};

inline Expansion<2> difference(double a, double b) {
  double x, y;
  two_diff(a, b, x, y);
  Expansion<2> r;
  r.push(y);
  r.push(x);
  return r;
}

/// Linear-time sum: components of both merged by magnitude, then accumulated.
template <int N, int M>
Expansion<N + M> operator+(const Expansion<N>& e, const Expansion<M>& f) {
  Expansion<N + M> r;
  int i = 0, j = 0;
  const auto next = [&]() {
    if (j == f.size || (i < e.size && std::fabs(e.component[i]) < std::fabs(f.component[j]))) return e.component[i++];
    return f.component[j++];
  };
  const int total = e.size + f.size;
  if (total == 0) return r;
  double q = next();
  for (int k = 1; k < total; ++k) {
    double sum, error;
    two_sum(q, next(), sum, error);
    r.push(error);
    q = sum;
  }
  r.push(q);
  return r;
}

template <int N, int M>
Expansion<N + M> operator-(const Expansion<N>& e, const Expansion<M>& f) {
  return e + (-f);
}

template <int N>
Expansion<2 * N> operator*(const Expansion<N>& e, double b) {
  Expansion<2 * N> r;
  if (e.size == 0 || b == 0) return r;
  double q, error;
  two_product(e.component[0], b, q, error);
  r.push(error);
  for (int i = 1; i < e.size; ++i) {
    double product, tail, sum;
    two_product(e.component[i], b, product, tail);
    two_sum(q, tail, sum, error);
    r.push(error);
    fast_two_sum(product, sum, q, error);
    r.push(error);
  }
  r.push(q);
  return r;
}

/// Product with a number of at most two components.
template <int N>
Expansion<4 * N> operator*(const Expansion<N>& e, const Expansion<2>& f) {
  if (f.size == 0) return {};
  if (f.size == 1) return (e * f.component[0]) + Expansion<2 * N>{};
  return (e * f.component[0]) + (e * f.component[1]);
}

}  // namespace oblast::internal::exact
