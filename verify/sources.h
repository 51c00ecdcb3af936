// The input edges of a result, with exact tests of distance and origin.
#pragma once

#include <oblast/options.h>
#include <oblast/region_set.h>

#include <vector>

#include "verify/rational.h"
#include "verify/slabs.h"

namespace oblast::verify {

struct InputEdge {
  Point from;
  Point to;
  std::size_t polygon;  ///< counted through both operands; npos if the fill rule does not use polygons

  static constexpr std::size_t npos = static_cast<std::size_t>(-1);
};

/// All edges of both operands, without those of length zero.
class Sources {
 public:
  Sources(const RegionView& a, const RegionView& b, const Options& options, double bound_ulps);

  const std::vector<InputEdge>& edges() const { return edges_; }

  /// The distance of the bound, in coordinate units; 0 without edges.
  double bound() const { return bound_; }
  double unit() const { return unit_; }

  bool is_vertex(const Point& p) const;
  bool is_rounded_intersection(const Point& p) const;

  /// True if p is within the bound of an edge. Exact; rationals are used only if an estimate cannot decide.
  bool near(const Point& p, const InputEdge& edge) const;
  bool near(const RationalPoint& p, const InputEdge& edge) const;

  /// True if the centre of the trapezoid is within the bound of any edge. Exact.
  bool near_any(const Trapezoid& trapezoid) const;

  /// The indices of the edges within the bound of both points, and therefore of all points between them.
  std::vector<std::size_t> near_both(const Point& p, const Point& q) const;

  /// True if two edges of one polygon meet near p. A polygon whose rings meet is resolved first, separately. Its new
  /// vertices are then input vertices of the overlay.
  bool may_be_resolved(const Point& p) const;

  /// The distance from p to the nearest edge, in units in the last place of the largest coordinate, exact to about a
  /// thousandth of a unit; 0 without edges.
  double displacement_ulps(const Point& p) const;

  /// True if every edge at vertex p may have cancelled. There are four cases. A stretch of the edge from p on, three
  /// times as long as the bound (or the whole edge), ends within the bound of another input edge: rounding may have put
  /// both onto one line. Or the edge meets another edge within the bound of p: the tip beyond that edge may have become
  /// flat. Or another edge leaves p in the same direction: the shorter of the two cancels. Or p is a flat tip.
  bool may_have_cancelled(const Point& p) const;

  /// True if vertex p may be on an edge only because traces were removed from the edge, which moved it: p is not
  /// exactly on an input edge along it, and other edges meet it. (Pieces of an edge that meets others of its polygon do
  /// not count, because that polygon is resolved first.)
  bool may_have_moved_onto(const Point& p, const Point& from, const Point& to) const;

 private:
  enum class Answer { no, yes, unknown };
  Answer estimate_near(const EstimatedPoint& p, const InputEdge& edge) const;
  bool exactly_near(const RationalPoint& p, const InputEdge& edge) const;
  /// True if another edge of its polygon meets the edge, which must be one of edges(). Then that polygon is resolved
  /// first, and the edge may move.
  bool meets_own_polygon(const InputEdge& edge) const;
  /// The end of the stretch of edge e from its end p on that is to run along another edge. An edge no longer than it
  /// has rounding errors for its length: all of it may have come to lie on its neighbours.
  RationalPoint end_of_stretch(const Point& p, const InputEdge& e) const;
  /// True if an edge passes p within the bound, and all edges at p leave to the same side of it, or along it. Rounding
  /// may have moved that edge to the other side of p, and the tip beyond it may have become flat.
  bool may_be_flat_tip(const Point& p) const;
  void collect(const RegionView& regions, bool by_polygon, std::size_t first_polygon);

  std::vector<InputEdge> edges_;
  std::vector<Point> vertices_;  // sorted
  double unit_ = 0;              // unit in the last place of the largest coordinate
  double bound_ = 0;
  Rational squared_bound_;
};

}  // namespace oblast::verify
