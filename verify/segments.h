// The edges of operands and result in one array, and the exact questions the oracle asks of an edge and a point.
#pragma once

#include <oblast/region_set.h>

#include <cstdint>
#include <span>
#include <vector>

namespace oblast::verify {

/// Whose edge it is.
enum class EdgeOf : std::uint8_t { a, b, result };

struct Segment {
  Point from;
  Point to;
  std::uint32_t polygon;  ///< within its operand
  EdgeOf owner;
};

struct Box {
  double x0, y0, x1, y1;

  void include(const Point& p);
};

/// All edges of A, B and the result, without those of length zero.
/// Throws std::length_error from 2^32 - 1 edges.
class Segments {
 public:
  Segments(const RegionView& a, const RegionView& b, const RegionView& result);

  const Segment& operator[](std::uint32_t i) const { return all_[i]; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(all_.size()); }
  /// The edges of A and B come first, those of the result after them.
  std::uint32_t input_count() const { return input_count_; }

  /// The unit in the last place of the largest coordinate of A and B, but not less than the domain's smallest
  /// magnitude (crossings are put into the domain). 0 without edges.
  double unit() const { return unit_; }
  /// Of all edges. REQUIRES: there are edges.
  const Box& box() const { return box_; }

 private:
  void collect(const RegionView& regions, EdgeOf owner);

  std::vector<Segment> all_;
  std::uint32_t input_count_ = 0;
  double unit_ = 0;
  Box box_{};
};

/// More than coordinates computed along an edge, or in the middle of a box, are off by: 16 units in the last place of
/// the largest coordinate of all.
double rounding_along(const Segments& segments);

/// False only when no point of the segment lies within `margin` of the box in both coordinates. Doubles: true where it
/// is close.
bool may_reach(const Segment& s, const Box& box, double margin);

/// On which side of the segment's line q' lies, +1 left or -1 right, never 0. Here q' is q moved to the left by an
/// infinitesimal and up by an infinitesimally smaller one, so that it lies on no line. Exact.
int side_of(const Segment& s, const Point& q);

/// True when the upright ray to the left (or right) of q' can meet the segment: one end lies above q', one below.
inline bool spans_height_of(const Segment& s, const Point& q) { return (s.from.y <= q.y) != (s.to.y <= q.y); }
/// The same of the line up and down from q'.
inline bool spans_width_of(const Segment& s, const Point& q) { return (s.from.x < q.x) != (s.to.x < q.x); }

/// Whether p lies in the closed box of the segment.
bool in_box_of(const Segment& s, const Point& p);

/// Whether p lies on the segment, ends included. Exact.
bool lies_on(const Segment& s, const Point& p);

/// The distance of p from the segment when p lies in its box: with 100 bits, then rounded to a double.
double distance_in_box(const Segment& s, const Point& p);

/// True unless p certainly lies outside of the segment's box or further than `bound` from it.
bool may_be_near(const Segment& s, const Point& p, double bound);

}  // namespace oblast::verify
