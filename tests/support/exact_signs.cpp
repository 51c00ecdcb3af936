#include "support/exact_signs.h"

#include <algorithm>
#include <cmath>

namespace oblast::testing {
namespace {

int lowest_exponent(double x) { return x == 0 ? 5000 : std::ilogb(x) - 52; }

Integer scaled(double x, int shift) {
  if (x == 0) return 0;
  int exponent;
  const double mantissa = std::ldexp(std::frexp(x, &exponent), 53);
  Integer r = static_cast<long long>(mantissa);
  const int left = exponent - 53 + shift;
  if (left >= 0) return r << static_cast<unsigned>(left);
  return r / (Integer(1) << static_cast<unsigned>(-left));
}

}  // namespace

std::vector<IntegerPoint> to_integers(std::span<const Point> points) {
  int lowest = 5000;
  for (const Point& p : points) lowest = std::min({lowest, lowest_exponent(p.x), lowest_exponent(p.y)});
  std::vector<IntegerPoint> integers;
  integers.reserve(points.size());
  for (const Point& p : points) integers.push_back({scaled(p.x, -lowest), scaled(p.y, -lowest)});
  return integers;
}

Integer doubled_area(const IntegerPoint& a, const IntegerPoint& b, const IntegerPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

int exact_orientation(const Point& a, const Point& b, const Point& c) {
  const Point points[] = {a, b, c};
  const auto p = to_integers(points);
  return doubled_area(p[0], p[1], p[2]).sign();
}

int exact_in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point points[] = {a, b, c, d};
  const auto p = to_integers(points);
  // The lifted determinant, expanded along the column of squares.
  Integer determinant = 0;
  for (int i = 0; i < 3; ++i) {
    const auto &q = p[i], &r = p[(i + 1) % 3], &s = p[(i + 2) % 3];
    const Integer dx = q.x - p[3].x, dy = q.y - p[3].y;
    determinant += (dx * dx + dy * dy) * doubled_area(p[3], r, s);
  }
  return determinant.sign();
}

}  // namespace oblast::testing
