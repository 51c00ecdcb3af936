// Distances from segments: estimates with bounds of their errors, and exact comparisons.
#pragma once

#include "verify/location.h"

namespace oblast::verify {

/// A number between these.
struct Interval {
  double low, high;
};

/// The distance from p to the closed segment.
Interval estimated_distance(const Point& p, const Stroke& s);

/// sqrt(a) <= sqrt(b) + e, exactly. REQUIRES: none is negative.
bool root_is_within(const Rational& a, const Rational& b, const Rational& e);

}  // namespace oblast::verify
