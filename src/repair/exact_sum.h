// A sum of doubles and of products of doubles, without any rounding: to compare areas exactly.
//
// It is an expansion (exact/expansion.h) of any length. Terms are products of two coordinates, multiples of 2^-704
// below 2^601, so a hundred components suffice, and three or four are usual.
#pragma once

#include <oblast/region_set.h>

#include "base/call_memory.h"
#include "exact/expansion.h"

namespace oblast::internal::repairing {

class ExactSum {
 public:
  void add(double term) {
    std::size_t kept = 0;
    for (const double component : components_) {
      double sum, error;
      exact::two_sum(term, component, sum, error);
      if (error != 0) components_[kept++] = error;
      term = sum;
    }
    components_.resize(kept);
    if (term != 0) components_.push_back(term);
  }
  void add_product(double a, double b) {
    double product, error;
    exact::two_product(a, b, product, error);
    add(error);
    add(product);
  }
  void add(const ExactSum& other) {
    for (const double component : other.components_) add(component);
  }
  void subtract(const ExactSum& other) {
    for (const double component : other.components_) add(-component);
  }

  /// The sign of an expansion is the sign of its largest component.
  int sign() const { return components_.empty() ? 0 : components_.back() > 0 ? 1 : -1; }
  /// Within one unit in the last place.
  double estimate() const {
    double sum = 0;
    for (const double component : components_) sum += component;
    return sum;
  }
  /// As few components as there may be.
  void compress();

 private:
  Array<double> components_;  ///< of growing magnitude, without overlaps, none zero
};

/// Twice the signed area of all contours. Cost: linear.
ExactSum twice_area(const RegionView& regions);

}  // namespace oblast::internal::repairing
