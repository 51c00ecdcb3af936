// A noded arrangement, its winding numbers and the areas of its faces, recomputed by exact integers.
//
// The pipeline chooses its results from one set of noded edges, whatever the operation. On that set nothing is rounded
// any more, so areas are exact and must add up exactly: |A or B| + |A and B| = |A| + |B|. Here the winding numbers come
// from a ray down from the middle of each edge, one edge at a time: slow, simple, and not how any engine labels.
#pragma once

#include <oblast/options.h>

#include <span>
#include <vector>

#include "verify/scaled.h"
#include "verify/verify.h"

namespace oblast::verify {

/// An edge after noding, and how much the winding numbers of A and B grow when it is crossed from its right to its
/// left.
struct NodedEdge {
  Point from;
  Point to;
  int change_a;
  int change_b;
};

class NodedArrangement {
 public:
  /// Rules that read polygons one by one count how many polygons cover a place: each has winding number 1 on its
  /// region. REQUIRES: edges in the domain and not of length zero.
  NodedArrangement(std::vector<NodedEdge> edges, const FillRule& rule_a, const FillRule& rule_b);

  /// Two edges that cross, overlap, or of which one touches the inside of the other. Cost: quadratic.
  std::optional<Fault> check_settled() const;

  /// Twice the area of A op B, and of the operands, in square units of the scale. Cost: quadratic.
  /// REQUIRES: check_settled() found no fault.
  struct Areas {
    WideInteger a, b;
    WideInteger by_operation[4];  ///< indexed by Operation
  };
  Areas twice_areas() const;

  /// Twice the area enclosed by a contour whose vertices are vertices of the arrangement, counter-clockwise positive.
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
