// Regions as flat arrays: the input and the output of overlays.
//
//   points         p0 p1 p2 p3 | p4 p5 p6 | p7 p8 p9 p10
//   contour_ends   4, 7, 11          contour c is points [contour_ends[c-1], contour_ends[c])
//   polygon_ends   2, 3              polygon p is contours [polygon_ends[p-1], polygon_ends[p])
//
// A contour is closed implicitly: its last point is joined to its first. The first point is not repeated at the end;
// input may repeat it. Indices are 32-bit.
//
//   for (const oblast::PolygonView polygon : regions.polygons())
//     for (const std::span<const oblast::Point> contour : polygon.contours())
//       for (const oblast::Point& p : contour) ...
#pragma once

#include <oblast/export.h>
#include <oblast/point.h>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace oblast {

class ContourRange;
class PolygonRange;
class PolygonView;

/// A view of arrays that the caller owns. Nothing is copied. Any contours are allowed: they may cross themselves and
/// each other, overlap, repeat, nest and touch. If `polygon_ends` is empty, every contour is a polygon.
///
/// A view of a part of larger arrays uses their offsets unchanged. `first_point` and `first_contour` are the offsets at
/// which the part begins. All member functions count from the beginning of the part.
struct RegionView {
  std::span<const Point> points;
  std::span<const std::uint32_t> contour_ends;
  std::span<const std::uint32_t> polygon_ends;
  std::uint32_t first_point = 0;    ///< the value of contour_ends at which `points` begins
  std::uint32_t first_contour = 0;  ///< the value of polygon_ends at which `contour_ends` begins

  std::size_t contour_count() const { return contour_ends.size(); }
  std::size_t polygon_count() const { return polygon_ends.empty() ? contour_ends.size() : polygon_ends.size(); }

  std::uint32_t contour_begin(std::size_t c) const { return c == 0 ? 0 : contour_ends[c - 1] - first_point; }
  std::uint32_t contour_end(std::size_t c) const { return contour_ends[c] - first_point; }
  std::span<const Point> contour(std::size_t c) const {
    return points.subspan(contour_begin(c), contour_end(c) - contour_begin(c));
  }

  std::uint32_t polygon_begin(std::size_t p) const {
    if (polygon_ends.empty()) return static_cast<std::uint32_t>(p);
    return p == 0 ? 0 : polygon_ends[p - 1] - first_contour;
  }
  std::uint32_t polygon_end(std::size_t p) const {
    return polygon_ends.empty() ? static_cast<std::uint32_t>(p + 1) : polygon_ends[p] - first_contour;
  }

  /// A view of the contours [begin, end), each as a polygon. REQUIRES: begin <= end <= contour_count().
  RegionView contours_between(std::size_t begin, std::size_t end) const {
    if (begin == end) return {};
    const std::uint32_t from = contour_begin(begin);
    return {points.subspan(from, contour_end(end - 1) - from),
            contour_ends.subspan(begin, end - begin),
            {},
            first_point + from};
  }

  PolygonView polygon(std::size_t p) const;  ///< REQUIRES: p < polygon_count()
  PolygonRange polygons() const;             ///< a range of PolygonView
  ContourRange contours() const;             ///< a range of std::span<const Point>: the contours of all polygons
};

/// An iterator that counts an index for `Range::operator[]`. It holds a copy of the range, so it may outlive the range.
template <class Range, class Value>
class IndexIterator {
 public:
  using iterator_concept = std::random_access_iterator_tag;
  using iterator_category = std::input_iterator_tag;  // operator* returns a value, not a reference
  using difference_type = std::ptrdiff_t;
  using value_type = Value;
  using reference = Value;
  using pointer = void;

  IndexIterator() = default;
  IndexIterator(const Range& range, std::size_t index) : range_(range), index_(static_cast<difference_type>(index)) {}

  Value operator*() const { return range_[static_cast<std::size_t>(index_)]; }
  Value operator[](difference_type n) const { return *(*this + n); }
  IndexIterator& operator+=(difference_type n) { return index_ += n, *this; }
  IndexIterator& operator-=(difference_type n) { return index_ -= n, *this; }
  IndexIterator& operator++() { return *this += 1; }
  IndexIterator& operator--() { return *this -= 1; }
  IndexIterator operator++(int) { return std::exchange(*this, *this + 1); }
  IndexIterator operator--(int) { return std::exchange(*this, *this - 1); }

  friend IndexIterator operator+(IndexIterator i, difference_type n) { return i += n; }
  friend IndexIterator operator+(difference_type n, IndexIterator i) { return i += n; }
  friend IndexIterator operator-(IndexIterator i, difference_type n) { return i -= n; }
  friend difference_type operator-(const IndexIterator& i, const IndexIterator& j) { return i.index_ - j.index_; }
  friend bool operator==(const IndexIterator& i, const IndexIterator& j) { return i.index_ == j.index_; }
  friend auto operator<=>(const IndexIterator& i, const IndexIterator& j) { return i.index_ <=> j.index_; }

 private:
  Range range_;
  difference_type index_ = 0;
};

/// Contours as spans of their points. A view of the caller's arrays: a few words, cheap to copy.
class ContourRange {
 public:
  using Iterator = IndexIterator<ContourRange, std::span<const Point>>;

  ContourRange() = default;
  explicit ContourRange(const RegionView& regions) : regions_(regions) {}

  std::size_t size() const { return regions_.contour_count(); }
  bool empty() const { return size() == 0; }
  std::span<const Point> operator[](std::size_t c) const { return regions_.contour(c); }
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }

 private:
  RegionView regions_;
};

/// One polygon of a region set, as a RegionView that holds only this polygon. The arrays are not copied.
class PolygonView {
 public:
  explicit PolygonView(const RegionView& alone) : alone_(alone) {}

  operator const RegionView&() const { return alone_; }
  const RegionView& view() const { return alone_; }

  std::size_t contour_count() const { return alone_.contour_count(); }
  std::span<const Point> contour(std::size_t c) const { return alone_.contour(c); }
  ContourRange contours() const { return ContourRange(alone_); }

 private:
  RegionView alone_;
};

/// Polygons as PolygonViews. A view of the caller's arrays: a few words, cheap to copy.
class PolygonRange {
 public:
  using Iterator = IndexIterator<PolygonRange, PolygonView>;

  PolygonRange() = default;
  explicit PolygonRange(const RegionView& regions) : regions_(regions) {}

  std::size_t size() const { return regions_.polygon_count(); }
  bool empty() const { return size() == 0; }
  PolygonView operator[](std::size_t p) const { return regions_.polygon(p); }
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }

 private:
  RegionView regions_;
};

inline PolygonView RegionView::polygon(std::size_t p) const {
  RegionView alone = contours_between(polygon_begin(p), polygon_end(p));
  if (!polygon_ends.empty()) {
    alone.polygon_ends = polygon_ends.subspan(p, 1);
    alone.first_contour = first_contour + polygon_begin(p);
  }
  return PolygonView(alone);
}
inline PolygonRange RegionView::polygons() const { return PolygonRange(*this); }
inline ContourRange RegionView::contours() const { return ContourRange(*this); }

/// Contours and polygons that own their arrays. The result of an overlay is canonical (promise G3): polygons do not
/// overlap. The first contour of a polygon is its outer one, counter-clockwise; the others are its holes, clockwise.
/// Each contour starts at its lexicographically smallest vertex. Contours and polygons are sorted.
struct RegionSet {
  std::vector<Point> points;
  std::vector<std::uint32_t> contour_ends;
  std::vector<std::uint32_t> polygon_ends;

  bool empty() const { return points.empty(); }
  operator RegionView() const { return {points, contour_ends, polygon_ends}; }
  RegionView view() const { return *this; }
  PolygonView polygon(std::size_t p) const& { return view().polygon(p); }
  PolygonRange polygons() const& { return view().polygons(); }
  ContourRange contours() const& { return view().contours(); }
  // A temporary set ends with its statement, and the view would dangle.
  PolygonView polygon(std::size_t p) const&& = delete;
  PolygonRange polygons() const&& = delete;
  ContourRange contours() const&& = delete;

  friend bool operator==(const RegionSet&, const RegionSet&) = default;
};

/// The sum of the signed areas of all contours, in squared units of the coordinates. A counter-clockwise contour counts
/// positive, a clockwise one negative. For the result of an overlay this is the area of its regions.
/// Accuracy: the sum is computed in doubles. Divide each contour into triangles from its first vertex, with the edge
/// vectors (dx1, dy1) and (dx2, dy2). The error is at most 2^-50 times the sum of |dx1 dy2| + |dx2 dy1| over the
/// triangles. So the area of slivers alone may have the wrong sign. Cost: linear.
/// Throws Error: not_finite, out_of_domain, too_large, bad_offsets.
OBLAST_API double signed_area(const RegionView& regions);

}  // namespace oblast

// The iterators hold a copy of their range. <span> declares the template and compiles faster than <ranges>.
template <>
inline constexpr bool std::ranges::enable_borrowed_range<oblast::ContourRange> = true;
template <>
inline constexpr bool std::ranges::enable_borrowed_range<oblast::PolygonRange> = true;
