// Where a walker through the plane is: inside A, inside B, and how often the result goes round him.
#pragma once

#include <oblast/options.h>

#include <cstdint>
#include <span>
#include <vector>

#include "verify/segments.h"

namespace oblast::verify {

/// An edge of an operand of which it is not certain on which side the walker is, and where he is in truth.
struct UncertainEdge {
  const Segment* segment;
  int side;
};

/// What may be true.
struct MayBe {
  bool yes, no;
};

/// Starts outside of everything. Memory: a byte for each polygon of an operand whose rule reads polygons.
class Membership {
 public:
  Membership(const FillRule& a, std::size_t polygons_a, const FillRule& b, std::size_t polygons_b);

  /// The walker steps over the edge, to its left (+1) or to its right (-1).
  void step_over(const Segment& s, int side);

  bool in_a() const { return a_.inside(); }
  bool in_b() const { return b_.inside(); }
  /// Whether A (or B) may be here or not, with each of the uncertain edges on either side. Sorts them.
  MayBe may_be_in_a(std::span<UncertainEdge> edges_of_a) const { return a_.may_be_inside(edges_of_a); }
  MayBe may_be_in_b(std::span<UncertainEdge> edges_of_b) const { return b_.may_be_inside(edges_of_b); }

  /// 0 or 1 in a result that is closed.
  int result_winding() const { return result_winding_; }

 private:
  struct Side {
    FillRule rule;
    std::vector<std::uint8_t> odd;  // by polygon: is its even-odd rule inside here? Empty where not needed.
    std::int64_t covering = 0;      // how many polygons are
    std::int64_t winding = 0;

    void step_over(const Segment& s, int side);
    bool inside() const { return may_be_inside({}).yes; }
    MayBe may_be_inside(std::span<UncertainEdge> edges) const;
    MayBe by_number(std::int64_t low, std::int64_t high) const;
  };

  Side a_, b_;
  int result_winding_ = 0;
};

}  // namespace oblast::verify
