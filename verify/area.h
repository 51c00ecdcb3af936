// Whether places are inside closed rings, exactly, also for places that are no doubles, and for the two sides of a
// place on an edge.
#pragma once

#include <oblast/point.h>

#include <span>
#include <vector>

#include "verify/location.h"

namespace oblast::verify {

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
