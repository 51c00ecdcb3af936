// Sums of areas of triangles, with what rounding takes from them.
#pragma once

#include <oblast/point.h>

#include <cstddef>
#include <span>

namespace oblast::internal {

/// Neumaier's sum: as if added up in twice the precision.
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

/// Adds the signed area of a ring: the triangles of the fan from its first vertex, whose coordinates relative to that
/// vertex make terms small and cancellation little.
inline void add_ring_area(std::span<const Point> ring, CompensatedSum& sum) {
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Point &o = ring[0], &p = ring[i], &q = ring[i + 1];
    sum.add(((p.x - o.x) * (q.y - o.y) - (q.x - o.x) * (p.y - o.y)) / 2);
  }
}

}  // namespace oblast::internal
