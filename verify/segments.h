// The edges of operands and result in one array, and the exact tests of an edge and a point for the oracle.
#pragma once

#include <oblast/region_set.h>

#include <cstdint>
#include <span>
#include <vector>

namespace oblast::verify {

/// The owner of an edge.
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
/// Throws std::length_error for 2^32 - 1 edges or more.
class Segments {
 public:
  Segments(const RegionView& a, const RegionView& b, const RegionView& result);

  const Segment& operator[](std::uint32_t i) const { return all_[i]; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(all_.size()); }
  /// The edges of A and B come first, those of the result after them.
  std::uint32_t input_count() const { return input_count_; }

  /// The unit in the last place of the largest coordinate of A and B, but at least the smallest magnitude of the domain
  /// (crossings are rounded to the domain). 0 without edges.
  double unit() const { return unit_; }
  /// The box of all edges. REQUIRES: there are edges.
  const Box& box() const { return box_; }

 private:
  void collect(const RegionView& regions, EdgeOf owner);

  std::vector<Segment> all_;
  std::uint32_t input_count_ = 0;
  double unit_ = 0;
  Box box_{};
};

/// A bound of the error of coordinates that are computed along an edge or in the middle of a box: 16 units in the last
/// place of the largest coordinate.
double rounding_along(const Segments& segments);

/// False only if no point of the segment is within `margin` of the box in both coordinates. Computed in doubles: true
/// in close cases.
bool may_reach(const Segment& s, const Box& box, double margin);

/// On which side of the segment's line q' lies, +1 left or -1 right, never 0. Here q' is q moved to the left by an
/// infinitesimal and up by an infinitesimally smaller one, so that it lies on no line. Exact.
int side_of(const Segment& s, const Point& q);

/// True if the ray to the left (or right) of q' can meet the segment: one end is above q', one below.
inline bool spans_height_of(const Segment& s, const Point& q) { return (s.from.y <= q.y) != (s.to.y <= q.y); }
/// The same for the line up and down from q'.
inline bool spans_width_of(const Segment& s, const Point& q) { return (s.from.x < q.x) != (s.to.x < q.x); }

/// True if p lies in the closed box of the segment.
bool in_box_of(const Segment& s, const Point& p);

/// True if p lies on the segment, ends included. Exact.
bool lies_on(const Segment& s, const Point& p);

/// The distance of p from the segment, with 100 bits, then rounded to a double. REQUIRES: p lies in the box of the
/// segment.
double distance_in_box(const Segment& s, const Point& p);

/// True unless p is certainly outside the box of the segment or further than `bound` from it.
bool may_be_near(const Segment& s, const Point& p, double bound);

}  // namespace oblast::verify
