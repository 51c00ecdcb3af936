// Sums of areas of triangles, with compensation of rounding errors.
#pragma once

#include <oblast/point.h>

#include <cstddef>
#include <span>

namespace oblast::internal {

/// Neumaier's compensated sum: as exact as with twice the precision.
class CompensatedSum {
 public:
  void add(double term) {
    const double next = sum_ + term;
    const bool sum_larger = (sum_ < 0 ? -sum_ : sum_) >= (term < 0 ? -term : term);
    compensation_ += sum_larger ? (sum_ - next) + term : (term - next) + sum_;
    sum_ = next;
  }
  double value() const { return sum_ + compensation_; }

 private:
  double sum_ = 0, compensation_ = 0;
};

/// Adds the signed area of a ring: the sum over the triangles of the fan from its first vertex. Coordinates relative to
/// that vertex make terms and cancellation small.
inline void add_ring_area(std::span<const Point> ring, CompensatedSum& sum) {
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Point &o = ring[0], &p = ring[i], &q = ring[i + 1];
    sum.add(((p.x - o.x) * (q.y - o.y) - (q.x - o.x) * (p.y - o.y)) / 2);
  }
}

}  // namespace oblast::internal
