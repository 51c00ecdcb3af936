// Builds region sets contour by contour, from points of any type.
//
//   oblast::RegionBuilder builder;
//   builder.add_polygon(shell);                  // a polygon without holes
//   builder.add_polygon(shell, hole, hole);      // a polygon with holes
//   builder.begin_polygon();                     // or contour by contour, until the next polygon begins
//   for (const auto& ring : rings) builder.add_contour(ring);
//   const oblast::RegionSet regions = builder.take();
#pragma once

#include <oblast/domain.h>
#include <oblast/error.h>
#include <oblast/region_set.h>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

namespace oblast {

namespace internal {

template <class P>
concept PointOfMembers = requires(const P& p) {
  { p.x } -> std::convertible_to<double>;
  { p.y } -> std::convertible_to<double>;
};
template <class P>
concept PointOfMethods = !PointOfMembers<P> && requires(const P& p) {
  { p.x() } -> std::convertible_to<double>;
  { p.y() } -> std::convertible_to<double>;
};
template <class P>
concept PointOfTuple = !PointOfMembers<P> && !PointOfMethods<P> && requires(const P& p) {
  requires std::tuple_size<P>::value >= 2;
  get<0>(p);
  get<1>(p);
};
template <class P>
concept PointOfArray = std::is_array_v<P> && std::extent_v<P>
>= 2 && std::convertible_to<std::remove_extent_t<P>, double>;

}  // namespace internal

/// A type that can be a point. It has members or member functions `x` and `y`; or it is a std::array, std::pair,
/// std::tuple or similar type, or a plain array, whose first two elements are numbers. Further elements, such as a
/// height, are ignored.
template <class P>
concept AnyPoint = internal::PointOfMembers<P> || internal::PointOfMethods<P> || internal::PointOfTuple<P> ||
    internal::PointOfArray<P>;

/// A type that can be a contour: a range-based `for` can iterate over it, and its elements are points (AnyPoint).
template <class R>
concept AnyContour = requires(const R& range) {
  {std::begin(range) != std::end(range)};
  requires AnyPoint<std::remove_cvref_t<decltype(*std::begin(range))>>;
};

/// Collects contours into a RegionSet. Contours may have any direction and may be degenerate, as overlays allow. A
/// contour is closed without a repetition of its first point; a repeated first point is kept and does no harm. Whole
/// numbers that a double cannot represent are an error, not rounded. Only `long double` is rounded.
///
/// If a function throws, everything that was added before is unchanged.
class RegionBuilder {
 public:
  /// Reserves memory for so many points, contours and polygons. This only saves time. Throws std::bad_alloc.
  void reserve(std::size_t points, std::size_t contours = 0, std::size_t polygons = 0) {
    regions_.points.reserve(points);
    regions_.contour_ends.reserve(contours);
    regions_.polygon_ends.reserve(polygons);
  }

  /// Begins a polygon: the contours that add_contour adds from now on belong to it. It ends at the next begin_polygon,
  /// add_polygon or take.
  void begin_polygon() { begun_ = true, open_ = false; }

  /// Adds a contour to the polygon that was begun. If none was begun, the contour becomes a polygon. Cost: linear.
  /// Throws Error, with polygon, contour and vertex: not_finite; out_of_domain, also for a whole number that a double
  /// cannot represent; too_large. Throws std::bad_alloc.
  template <AnyContour Contour>
  void add_contour(const Contour& contour) {
    append(contour);
    close(!begun_ || !open_);
    open_ = true;
  }

  /// Adds a polygon from its shell and its holes. Each may be a different type. A contour that add_contour adds
  /// afterwards becomes a polygon, unless begin_polygon is called first. Errors as for add_contour; then no part of the
  /// polygon is added.
  template <AnyContour Shell, AnyContour... Holes>
  void add_polygon(const Shell& shell, const Holes&... holes) {
    const RegionSizes before = sizes();
    try {
      append(shell);
      close(true);
      ((append(holes), close(false)), ...);
    } catch (...) {
      shrink(before);
      throw;
    }
    begun_ = open_ = false;
  }

  /// Everything that was added so far.
  const RegionSet& regions() const { return regions_; }

  /// Returns everything that was added, and empties the builder.
  RegionSet take() {
    begun_ = open_ = false;
    return std::exchange(regions_, RegionSet{});
  }

 private:
  static constexpr std::size_t most_points = 0x7fffffff;  // of a call

  struct RegionSizes {
    std::size_t points, contours, polygons;
  };
  RegionSizes sizes() const {
    return {regions_.points.size(), regions_.contour_ends.size(), regions_.polygon_ends.size()};
  }
  void shrink(const RegionSizes& to) {
    regions_.points.resize(to.points);
    regions_.contour_ends.resize(to.contours);
    regions_.polygon_ends.resize(to.polygons);
    if (to.polygons > 0) regions_.polygon_ends.back() = static_cast<std::uint32_t>(to.contours);
  }

  template <class P>
  static auto coordinates(const P& p) {
    if constexpr (internal::PointOfMembers<P>)
      return std::pair(p.x, p.y);
    else if constexpr (internal::PointOfMethods<P>)
      return std::pair(p.x(), p.y());
    else if constexpr (internal::PointOfTuple<P>)
      return std::pair(get<0>(p), get<1>(p));
    else
      return std::pair(p[0], p[1]);
  }

  Place place(std::size_t first) const {
    const bool in_polygon = begun_ && open_;
    return {Place::npos, regions_.polygon_ends.size() - (in_polygon ? 1 : 0), regions_.contour_ends.size(),
            regions_.points.size() - first};
  }

  template <class Number>
  double to_double(Number number, std::size_t first) const {
    if constexpr (std::integral<Number>) {
      constexpr auto exact_bits = std::numeric_limits<double>::digits;
      if constexpr (std::numeric_limits<Number>::digits > exact_bits) {
        const auto magnitude = number < 0 ? 0 - static_cast<std::make_unsigned_t<Number>>(number)
                                          : static_cast<std::make_unsigned_t<Number>>(number);
        // A double does not store low bits that are zero.
        if (magnitude != 0 && (magnitude / (magnitude & (0 - magnitude))) >> exact_bits != 0)
          throw Error(ErrorCode::out_of_domain,
                      "a double cannot represent the whole number " + std::to_string(number) + " exactly",
                      place(first));
      }
      return static_cast<double>(number);
    } else {
      const double coordinate = static_cast<double>(number);
      if (!in_domain(coordinate)) [[unlikely]]
        throw std::isfinite(coordinate)
            ? Error(ErrorCode::out_of_domain,
                    "coordinate outside the domain: its magnitude must be 0 or between 2^-300 and 2^300", place(first))
            : Error(ErrorCode::not_finite, "coordinate is not a finite number", place(first));
      return coordinate;
    }
  }

  template <class Contour>
  void append(const Contour& contour) {
    const std::size_t first = regions_.points.size();
    try {
      for (const auto& p : contour) {
        if (regions_.points.size() == most_points)
          throw Error(ErrorCode::too_large, "too large: more than 2147483647 vertices", place(first));
        const auto [x, y] = coordinates(p);
        regions_.points.push_back({to_double(x, first), to_double(y, first)});
      }
    } catch (...) {
      regions_.points.resize(first);
      throw;
    }
  }

  /// Makes the points after the last contour a contour, of a new polygon or of the last one.
  void close(bool new_polygon) {
    const RegionSizes before{regions_.contour_ends.empty() ? 0 : regions_.contour_ends.back(),
                             regions_.contour_ends.size(), regions_.polygon_ends.size()};
    try {
      regions_.contour_ends.push_back(static_cast<std::uint32_t>(regions_.points.size()));
      const auto contours = static_cast<std::uint32_t>(regions_.contour_ends.size());
      if (new_polygon)
        regions_.polygon_ends.push_back(contours);
      else
        regions_.polygon_ends.back() = contours;
    } catch (...) {
      shrink(before);
      throw;
    }
  }

  RegionSet regions_;
  bool begun_ = false;  ///< begin_polygon was called
  bool open_ = false;   ///< the polygon that was begun has a contour
};

}  // namespace oblast
