// The input edges that a result is made of: exact questions of distance and origin.
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
  std::size_t polygon;  ///< counted through both operands; npos where the fill rule does not see polygons

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

  /// Whether p lies within the bound of an edge. Exact; rationals only where an estimate cannot tell.
  bool near(const Point& p, const InputEdge& edge) const;
  bool near(const RationalPoint& p, const InputEdge& edge) const;

  /// Whether the trapezoid's centre lies within the bound of any edge. Exact.
  bool near_any(const Trapezoid& trapezoid) const;

  /// Edges (by index) within the bound of both points, hence of all between them.
  std::vector<std::size_t> near_both(const Point& p, const Point& q) const;

  /// True when two edges of one polygon meet about p: a polygon whose rings meet is resolved by itself first, and
  /// its new vertices then are input vertices of the overlay.
  bool may_be_resolved(const Point& p) const;

  /// Distance from p to the nearest edge, in units of the last place of the largest coordinate, to about a thousandth
  /// of one; 0 without edges.
  double displacement_ulps(const Point& p) const;

  /// True when every edge at vertex p may have cancelled: a stretch of three times the bound from p on, or the whole
  /// edge if it is shorter, ends within the bound of another input edge, so rounding may have put both onto one line;
  /// or the edge meets another one within the bound of p, so the tip beyond it may have become flat; or another edge
  /// leaves p in the same direction, so the shorter of the two cancels.
  bool may_have_cancelled(const Point& p) const;

  /// True when vertex p may lie on an edge only since traces were taken out of it, which moved it: p is not exactly on
  /// an input edge along it (pieces of an edge that meets others of its polygon do not count: it is resolved first),
  /// and other edges meet it.
  bool may_have_moved_onto(const Point& p, const Point& from, const Point& to) const;

 private:
  enum class Answer { no, yes, unknown };
  Answer estimate_near(const EstimatedPoint& p, const InputEdge& edge) const;
  bool exactly_near(const RationalPoint& p, const InputEdge& edge) const;
  bool meets_own_polygon(std::size_t edge) const;
  void collect(const RegionView& regions, bool by_polygon, std::size_t first_polygon);

  std::vector<InputEdge> edges_;
  std::vector<Point> vertices_;  // sorted
  double unit_ = 0;              // unit in the last place of the largest coordinate
  double bound_ = 0;
  Rational squared_bound_;
};

}  // namespace oblast::verify
