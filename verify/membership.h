// The state of a walker in the plane: whether it is inside A and inside B, and the winding number of the result around
// it.
#pragma once

#include <oblast/options.h>

#include <cstdint>
#include <span>
#include <vector>

#include "verify/segments.h"

namespace oblast::verify {

/// An edge of an operand for which the true side of the walker is uncertain, with the side on which it is computed to
/// be.
struct UncertainEdge {
  const Segment* segment;
  int side;
};

/// The possible answers.
struct MayBe {
  bool yes, no;
};

/// Starts outside of everything. Memory: one byte per polygon of an operand whose fill rule uses polygons.
class Membership {
 public:
  Membership(const FillRule& a, std::size_t polygons_a, const FillRule& b, std::size_t polygons_b);

  /// The walker crosses the edge, to its left (+1) or to its right (-1).
  void step_over(const Segment& s, int side);

  bool in_a() const { return a_.inside(); }
  bool in_b() const { return b_.inside(); }
  /// Whether the walker may be inside or outside A (or B) if each uncertain edge may be on either side. Sorts the
  /// edges.
  MayBe may_be_in_a(std::span<UncertainEdge> edges_of_a) const { return a_.may_be_inside(edges_of_a); }
  MayBe may_be_in_b(std::span<UncertainEdge> edges_of_b) const { return b_.may_be_inside(edges_of_b); }

  /// The winding number of the result. For a closed result it is 0 or 1.
  int result_winding() const { return result_winding_; }

 private:
  struct Side {
    FillRule rule;
    std::vector<std::uint8_t> odd;  // by polygon: whether the walker is inside by even-odd; empty if not needed
    std::int64_t covering = 0;      // number of polygons that the walker is inside
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
