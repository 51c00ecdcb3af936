// Exact places that are no doubles, and segments.
#pragma once

#include <oblast/point.h>

#include <optional>

#include "verify/box_tree.h"
#include "verify/estimate.h"
#include "verify/rational.h"

namespace oblast::verify {

/// A segment between two points; a point if they are equal.
struct Stroke {
  Point a, b;

  Box box() const { return {a, b}; }
  friend bool operator==(const Stroke&, const Stroke&) = default;
};

/// An exact place. Rational coordinates are computed only when an estimate does not decide.
class Location {
 public:
  explicit Location(const Point& p) : estimate_(p), first_(p), second_(p), is_double_(true) {}
  explicit Location(const RationalPoint& p);
  /// The place in the middle of two.
  Location(const Location& p, const Location& q);

  bool is_double() const { return is_double_; }
  const EstimatedPoint& estimate() const { return estimate_; }
  Point rounded() const { return {static_cast<double>(estimate_.x.value), static_cast<double>(estimate_.y.value)}; }
  const RationalPoint& exact() const;
  /// A box of doubles that holds the place.
  Box box() const;

 private:
  EstimatedPoint estimate_;
  Point first_, second_;  ///< the place is in the middle of these, unless exact_ was given
  bool is_double_ = false;
  mutable std::optional<RationalPoint> exact_;
};

/// +1 if `p` lies left of the directed line a -> b, -1 right of it, 0 on it.
int side_of_line(const Point& a, const Point& b, const Location& p);

/// The sign of p.y - y.
int compare_y(const Location& p, double y);

}  // namespace oblast::verify
