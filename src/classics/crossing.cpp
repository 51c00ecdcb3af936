// A floating-point filter, then expansions. With u = 2^-53, the error of the determinant of two difference vectors is
// at most (3 + 16u) u (|left| + |right|). The proof in exact/orientation.h holds for any two differences.
#include "classics/crossing.h"

#include <cmath>

#include "exact/expansion.h"

namespace oblast::internal::classics {
namespace {

using exact::Expansion;

/// (b - a) x (d - c), for the four points of two directions.
struct Determinant {
  Point a, b, c, d;

  double approximate(double& error) const {
    const double left = (b.x - a.x) * (d.y - c.y), right = (b.y - a.y) * (d.x - c.x);
    error = 3.3306690738754716e-16 * (std::fabs(left) + std::fabs(right));
    return left - right;
  }
  Expansion<16> exactly() const {
    const auto abx = exact::difference(b.x, a.x), aby = exact::difference(b.y, a.y);
    const auto cdx = exact::difference(d.x, c.x), cdy = exact::difference(d.y, c.y);
    return abx * cdy - aby * cdx;
  }
};

int sign_of(double value, double error) { return value > error ? 1 : value < -error ? -1 : 0; }

/// The full product. `sum` never has more than twice the product of the numbers of components.
Expansion<512> product(const Expansion<16>& e, const Expansion<16>& f) {
  Expansion<512> sum;
  for (int i = 0; i < f.size; ++i) {
    const auto next = sum + e * f.component[i];
    sum.size = next.size;
    for (int k = 0; k < next.size; ++k) sum.component[k] = next.component[k];
  }
  return sum;
}

}  // namespace

int turn(const Line& a, const Line& b) {
  const Determinant determinant{a.p, a.q, b.p, b.q};
  double error;
  const double value = determinant.approximate(error);
  const int sign = sign_of(value, error);
  return sign != 0 || error == 0 ? sign : determinant.exactly().sign();
}

// With r = a.q - a.p, s = b.q - b.p, t = line.q - line.p the crossing is a.p + r N / D, D = r x s and
// N = (b.p - a.p) x s, and its side is the sign of O + (t x r) N / D, O = t x (a.p - line.p).
int side_of_crossing(const Line& a, const Line& b, const Line& line) {
  const Determinant d{a.p, a.q, b.p, b.q}, n{a.p, b.p, b.p, b.q};
  const Determinant o{line.p, line.q, line.p, a.p}, k{line.p, line.q, a.p, a.q};
  double d_error, n_error, o_error, k_error;
  const double d_value = d.approximate(d_error), n_value = n.approximate(n_error);
  const double o_value = o.approximate(o_error), k_value = k.approximate(k_error);
  const double left = o_value * d_value, right = k_value * n_value;
  const auto product_error = [](double x, double x_error, double y, double y_error) {
    return std::fabs(x) * y_error + std::fabs(y) * x_error + x_error * y_error + 0x1p-52 * std::fabs(x * y);
  };
  const double error = 1.001 * (product_error(o_value, o_error, d_value, d_error) +
                                product_error(k_value, k_error, n_value, n_error) + 0x1p-52 * std::fabs(left + right));
  const int d_sign = sign_of(d_value, d_error);
  const int sign = sign_of(left + right, error);
  if (d_sign != 0 && sign != 0) return d_sign * sign;
  const auto d_exact = d.exactly();
  return d_exact.sign() * (product(o.exactly(), d_exact) + product(k.exactly(), n.exactly())).sign();
}

}  // namespace oblast::internal::classics
