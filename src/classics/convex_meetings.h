// All points at which the boundaries of two convex contours meet, by O'Rourke's advance.
#pragma once

#include <cstdint>

#include "base/call_memory.h"
#include "classics/operand.h"
#include "window/contours.h"

namespace oblast::internal::classics {

/// A contour cut at its meetings with the other one. Chain k runs from node k to node k + 1.
struct NodedContour {
  Array<Point> points;
  Array<bool> rounded;         ///< by point: a rounded crossing
  Array<std::uint32_t> nodes;  ///< indices of the points that lie on the other contour, increasing

  const Point& next(std::uint32_t i) const { return points[i + 1 == points.size() ? 0 : i + 1]; }
  const Point& previous(std::uint32_t i) const { return points[i == 0 ? points.size() - 1 : i - 1]; }

  /// Adds the points of a chain, without the last one.
  void add_chain(std::size_t k, window::Contours& result) const;
  /// The same backward: from node k + 1, without node k.
  void add_chain_backward(std::size_t k, window::Contours& result) const;
};

class ConvexMeetings {
 public:
  /// REQUIRES: both are convex and counter-clockwise.
  ConvexMeetings(const Ring& a, const Ring& b) : a_(a), b_(b) {}

  /// Advances around both contours and cuts them. Returns the number of advances, at most 2(n1 + n2).
  std::uint64_t find();

  const NodedContour& contour_a() const { return noded_a_; }
  const NodedContour& contour_b() const { return noded_b_; }

  /// The order of the nodes of B, relative to those of A.
  enum class Order {
    same,       ///< node k of B is node k of A
    opposite,   ///< node k of B is node m - 1 - k of A: the contours touch from outside
    unsettled,  ///< rounding might change what meets what
  };
  /// Matches the nodes, and checks exactly that the pieces of A and B meet at their ends only and keep clear of each
  /// other. Cost: linear; for many rounded crossings, that of is_clear().
  Order settled_order();

 private:
  struct Cut {
    std::uint32_t edge;
    Point at;
    bool rounded;
  };

  void test_edges(std::uint32_t i, std::uint32_t j);
  static void vertex_on_edge(const Point& p, const Ring& ring, std::uint32_t edge, Array<Cut>& cuts);
  static bool cut(const Ring& ring, Array<Cut>& cuts, NodedContour& noded);
  bool pieces_are_clear() const;

  const Ring& a_;
  const Ring& b_;
  Array<Cut> cuts_a_, cuts_b_;
  NodedContour noded_a_, noded_b_;
  bool collapsed_ = false;  ///< two different points were rounded to the same point
};

}  // namespace oblast::internal::classics
