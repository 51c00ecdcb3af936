// Whether places are inside closed rings, exactly, also for places that are no doubles, and for the two sides of a place
// on an edge.
#pragma once

#include <oblast/point.h>

#include <optional>
#include <span>
#include <vector>

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

/// The inside of closed rings, by even-odd, as a set of edges in any order.
class Area {
 public:
  explicit Area(std::vector<Stroke> edges);

  const std::vector<Stroke>& edges() const { return edges_; }
  const Box& box() const { return box_; }

  enum class Where { outside, on, inside };
  Where where(const Point& p) const;

  /// Whether the two sides of a place are inside: for a place on a horizontal segment the places just below and just
  /// above it, else those just to the west and to the east. If the place is on no edge, both are the same.
  /// REQUIRES: edges that the place is on overlap the segment there.
  struct Sides {
    bool first = false, second = false;
  };
  Sides beside(const Location& p, bool on_horizontal) const;

 private:
  std::size_t band_of(double y) const;
  std::span<const std::uint32_t> edges_at(double y) const;

  std::vector<Stroke> edges_;
  Box box_;
  std::size_t bands_ = 1;
  double per_band_ = 0;
  std::vector<std::uint32_t> band_ends_, in_band_;
};

}  // namespace oblast::verify
