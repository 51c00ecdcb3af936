#include "repair/exact_sum.h"

#include <algorithm>

namespace oblast::internal::repairing {

// Shewchuk 1997, figure 15: from the largest component down, then up again.
void ExactSum::compress() {
  if (components_.size() < 2) return;
  Array<double> downwards;
  double q = components_.back();
  for (std::size_t i = components_.size() - 1; i-- > 0;) {
    double sum, error;
    exact::fast_two_sum(q, components_[i], sum, error);
    if (error != 0) downwards.push_back(sum);
    q = error != 0 ? error : sum;
  }
  components_.clear();
  for (std::size_t i = downwards.size(); i-- > 0;) {
    double sum, error;
    exact::fast_two_sum(downwards[i], q, sum, error);
    if (error != 0) components_.push_back(error);
    q = sum;
  }
  if (q != 0) components_.push_back(q);
}

ExactSum twice_area(const RegionView& regions) {
  ExactSum sum;
  for (std::size_t c = 0; c < regions.contour_count(); ++c) {
    const std::span<const Point> ring = regions.contour(c);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &p = ring[i], &q = ring[i + 1 < ring.size() ? i + 1 : 0];
      sum.add_product(p.x, q.y);
      sum.add_product(-q.x, p.y);
    }
    sum.compress();
  }
  return sum;
}

}  // namespace oblast::internal::repairing
