// Three exact ways, from quick to slow; which one may be taken depends on the six differences.
//
//   1. Small whole numbers: when the differences are exact and whole and the sum of all absolute terms
//      is below 2^53, the determinant in doubles is exact. (Lattices, where cocircular points abound.)
//   2. Expansions. Scaled by a power of two, which changes no sign and loses nothing, the largest component
//      lies in [2^250, 2^251): the determinant stays below 12 * 2^1004 < 2^1008, and factors, below 2^505,
//      can be split. A component of magnitude 2^e is a multiple of 2^(e - 52); a product of four, of
//      2^(4 (e - 52)), which must not be below 2^-1074: so e >= -216 for the smallest component.
//   3. Whole numbers of 2^-352, the unit of the domain: at most 653 bits each, 2700 the determinant.
#include "exact/in_circle.h"

#include <algorithm>
#include <limits>

#include "exact/expansion.h"
#include "exact/expansion_product.h"
#include "exact/wide_integer.h"

namespace oblast::internal::exact {
namespace {

using Difference = Expansion<2>;

struct Differences {
  Difference ax, ay, bx, by, cx, cy;

  template <class Visit>
  void for_each(const Visit& visit) {
    for (Difference* d : {&ax, &ay, &bx, &by, &cx, &cy}) visit(*d);
  }
};

/// x * x + y * y.
Expansion<16> square(const Difference& x, const Difference& y) { return x * x + y * y; }

/// p.x * q.y - q.x * p.y.
Expansion<16> minor(const Difference& px, const Difference& py, const Difference& qx, const Difference& qy) {
  return px * qy - qx * py;
}

int sign_by_expansions(const Differences& d) {
  const auto a = product(minor(d.bx, d.by, d.cx, d.cy), square(d.ax, d.ay));
  const auto b = product(minor(d.cx, d.cy, d.ax, d.ay), square(d.bx, d.by));
  const auto c = product(minor(d.ax, d.ay, d.bx, d.by), square(d.cx, d.cy));
  return (a + b + c).sign();
}

/// Way 1. Returns 2 when it does not apply.
int sign_by_small_integers(Differences& d) {
  bool whole = true;
  d.for_each([&](const Difference& e) {
    whole &= e.size == 0 ||
             (e.size == 1 && std::fabs(e.component[0]) < 0x1p26 && std::rint(e.component[0]) == e.component[0]);
  });
  if (!whole) return 2;
  const double ax = d.ax.estimate(), ay = d.ay.estimate(), bx = d.bx.estimate(), by = d.by.estimate();
  const double cx = d.cx.estimate(), cy = d.cy.estimate();
  const double aa = ax * ax + ay * ay, bb = bx * bx + by * by, cc = cx * cx + cy * cy;
  const double permanent = aa * (std::fabs(bx * cy) + std::fabs(cx * by)) +
                           bb * (std::fabs(cx * ay) + std::fabs(ax * cy)) +
                           cc * (std::fabs(ax * by) + std::fabs(bx * ay));
  if (!(permanent < 0x1p53)) return 2;
  const double determinant = aa * (bx * cy - cx * by) + bb * (cx * ay - ax * cy) + cc * (ax * by - bx * ay);
  return determinant > 0 ? 1 : determinant < 0 ? -1 : 0;
}

/// Way 3.
int sign_by_wide_integers(const Point& a, const Point& b, const Point& c, const Point& d) {
  constexpr int unit = 352;
  const auto x = [&](const Point& p) { return WideInteger::scaled(p.x, unit) - WideInteger::scaled(d.x, unit); };
  const auto y = [&](const Point& p) { return WideInteger::scaled(p.y, unit) - WideInteger::scaled(d.y, unit); };
  const WideInteger ax = x(a), ay = y(a), bx = x(b), by = y(b), cx = x(c), cy = y(c);
  const WideInteger determinant = (ax * ax + ay * ay) * (bx * cy - cx * by) +
                                  (bx * bx + by * by) * (cx * ay - ax * cy) + (cx * cx + cy * cy) * (ax * by - bx * ay);
  return determinant.sign();
}

}  // namespace

int in_circle_exact(const Point& a, const Point& b, const Point& c, const Point& d) {
  Differences differences{difference(a.x, d.x), difference(a.y, d.y), difference(b.x, d.x),
                          difference(b.y, d.y), difference(c.x, d.x), difference(c.y, d.y)};
  if (const int sign = sign_by_small_integers(differences); sign != 2) return sign;

  double largest = 0, smallest = std::numeric_limits<double>::infinity();
  differences.for_each([&](const Difference& e) {
    if (e.size == 0) return;
    largest = std::max(largest, std::fabs(e.component[e.size - 1]));
    smallest = std::min(smallest, std::fabs(e.component[0]));
  });
  if (largest == 0) return 0;
  const int shift = 250 - std::ilogb(largest);
  if (std::ilogb(smallest) + shift < -216) return sign_by_wide_integers(a, b, c, d);
  const double scale = std::ldexp(1.0, shift);
  differences.for_each([&](Difference& e) {
    for (int i = 0; i < e.size; ++i) e.component[i] *= scale;
  });
  return sign_by_expansions(differences);
}

}  // namespace oblast::internal::exact
