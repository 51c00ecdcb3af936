// A noded arrangement, with its winding numbers and the areas of its faces, recomputed with exact integers.
//
// For every operation, the pipeline selects its result from the same set of noded edges. Nothing is rounded after that,
// so areas are exact and must add up exactly: |A or B| + |A and B| = |A| + |B|. Here a ray downwards from the midpoint
// of each edge gives the winding numbers. This is slow and simple, and independent of how the engines label.
#pragma once

#include <oblast/options.h>

#include <span>
#include <vector>

#include "verify/scaled.h"
#include "verify/verify.h"

namespace oblast::verify {

/// An edge after noding, and the change of the winding numbers of A and B from its right side to its left side.
struct NodedEdge {
  Point from;
  Point to;
  int change_a;
  int change_b;
};

class NodedArrangement {
 public:
  /// For fill rules that use polygons one by one, each polygon has winding number 1 in its region, so the sum is the
  /// number of polygons that cover a place. REQUIRES: edges are in the domain and do not have length zero.
  NodedArrangement(std::vector<NodedEdge> edges, const FillRule& rule_a, const FillRule& rule_b);

  /// Finds two edges that cross or overlap, or of which one touches the inside of the other. Cost: quadratic.
  std::optional<Fault> check_settled() const;

  /// Twice the area of A op B, and of the operands, in square units of the scale. Cost: quadratic.
  /// REQUIRES: check_settled() found no fault.
  struct Areas {
    WideInteger a, b;
    WideInteger by_operation[4];  ///< indexed by Operation
  };
  Areas twice_areas() const;

  /// Twice the signed area of a contour (positive if counter-clockwise) whose vertices are vertices of the arrangement.
  WideInteger twice_area_of(std::span<const Point> contour) const;

 private:
  struct Sides {
    bool a_left, a_right, b_left, b_right;
  };
  Sides sides_of(std::size_t edge) const;

  std::vector<NodedEdge> edges_;
  FillRule rule_a_, rule_b_;
  Scale scale_;
  std::vector<ScaledPoint> from_, to_;  // by edge
};

}  // namespace oblast::verify
