// Where a walker through the plane is: inside A, inside B, and how often the result goes round him.
#pragma once

#include <oblast/options.h>

#include <cstdint>
#include <vector>

#include "verify/segments.h"

namespace oblast::verify {

/// Starts outside of everything. Memory: a byte for each polygon of an operand whose rule reads polygons.
class Membership {
 public:
  Membership(const FillRule& a, std::size_t polygons_a, const FillRule& b, std::size_t polygons_b);

  /// The walker steps over the edge, to its left (+1) or to its right (-1).
  void step_over(const Segment& s, int side);

  bool in_a() const { return a_.inside(); }
  bool in_b() const { return b_.inside(); }
  /// 0 or 1 in a result that is closed.
  int result_winding() const { return result_winding_; }

 private:
  struct Side {
    FillRule rule;
    std::vector<std::uint8_t> odd;  // by polygon: is its even-odd rule inside here? Empty where not needed.
    std::int64_t covering = 0;      // how many polygons are
    std::int64_t winding = 0;

    void step_over(const Segment& s, int side);
    bool inside() const;
  };

  Side a_, b_;
  int result_winding_ = 0;
};

}  // namespace oblast::verify
