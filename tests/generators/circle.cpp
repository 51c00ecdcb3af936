// Taylor series in double-double arithmetic, after subtracting multiples of a quarter turn.
#include "generators/circle.h"

#include <cmath>

#include "exact/expansion.h"

namespace oblast::generators {
using namespace internal;
namespace {

using exact::fast_two_sum, exact::two_product, exact::two_sum;

/// high + low, |low| at most half a unit in the last place of high; about 106 bits.
struct Twofold {
  double high, low;
};

Twofold normalized(double high, double low) {
  Twofold r;
  fast_two_sum(high, low, r.high, r.low);
  return r;
}

Twofold operator+(const Twofold& a, const Twofold& b) {
  double high, error;
  two_sum(a.high, b.high, high, error);
  return normalized(high, error + (a.low + b.low));
}

Twofold operator*(const Twofold& a, const Twofold& b) {
  double high, error;
  two_product(a.high, b.high, high, error);
  return normalized(high, error + (a.high * b.low + a.low * b.high));
}

Twofold operator/(const Twofold& a, double b) {
  const double quotient = a.high / b;
  double product, error;
  two_product(quotient, b, product, error);
  return normalized(quotient, ((a.high - product) - error + a.low) / b);
}

struct Reduced {
  Twofold angle;  ///< of [-pi / 4, pi / 4]
  int quarters;   ///< modulo 4
};

Reduced reduced(double angle) {
  // A quarter turn in three parts of 33 bits, so that products with fewer than 2^20 quarters are exact, and a rest.
  constexpr double parts[] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2ep-69, 0x1.b839a252049c1p-104};
  const double quarters = std::floor(angle / (parts[0] + parts[1]) + 0.5);
  Twofold rest{angle, 0};
  for (const double part : parts) rest = rest + Twofold{-quarters * part, 0};
  return {rest, static_cast<int>(quarters) & 3};
}

/// 1 - s / (k (k + 1)) (1 - s / ((k + 2) (k + 3)) (1 - ...)), s = x^2: cos x where k is 1, sin x / x where k is 2.
Twofold series(const Twofold& x, int k) {
  constexpr int terms = 14;  // the next one is below 2^-110
  const Twofold minus_square = x * Twofold{-x.high, -x.low};
  Twofold sum{1, 0};
  for (int term = terms - 1; term >= 0; --term) {
    const int first = k + 2 * term;
    sum = Twofold{1, 0} + minus_square * sum / (first * (first + 1));
  }
  return sum;
}

double sine_of_quarters(const Reduced& r, int quarters) {
  const Twofold value = quarters % 2 == 0 ? r.angle * series(r.angle, 2) : series(r.angle, 1);
  return quarters % 4 < 2 ? value.high : -value.high;
}

}  // namespace

double sine(double angle) {
  const Reduced r = reduced(angle);
  return sine_of_quarters(r, r.quarters);
}

double cosine(double angle) {
  const Reduced r = reduced(angle);
  return sine_of_quarters(r, r.quarters + 1);
}

}  // namespace oblast::generators
