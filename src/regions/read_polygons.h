// The common part of the readers of polygons: they add rings one by one, and closing points are removed.
#pragma once

#include <oblast/domain.h>
#include <oblast/error.h>
#include <oblast/region_set.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "base/index.h"
#include "base/memory_budget.h"
#include "regions/validate.h"

namespace oblast::internal {

/// The deepest nesting of collections that readers accept. Each level is a frame of the stack of the reader of WKB.
inline constexpr int deepest_collection = 64;

inline Place at_byte(std::size_t byte) {
  Place place;
  place.byte = byte;
  return place;
}

/// The end of a message that has a byte position.
inline std::string words_for_byte(std::size_t byte) { return ", at byte " + std::to_string(byte); }

[[noreturn]] inline void throw_at_byte(ErrorCode code, const std::string& what, std::size_t byte) {
  throw Error(code, what + words_for_byte(byte), at_byte(byte));
}

/// Throws Error: not_finite, out_of_domain.
inline double checked_coordinate(double value, std::size_t byte) {
  if (in_domain(value)) [[likely]]
    return value;
  throw_bad_coordinate(std::isfinite(value), at_byte(byte), words_for_byte(byte));
}

/// Collects the polygons of a text or binary. Empty rings and polygons are left out.
class PolygonCollector {
 public:
  void begin_polygon() { contours_before_ = regions_.contour_ends.size(); }
  void add(const Point& p) {
    if (regions_.points.size() == regions_.points.capacity()) make_room();
    regions_.points.push_back(p);
  }
  void end_ring() {
    const std::size_t begin = regions_.contour_ends.empty() ? 0 : regions_.contour_ends.back();
    std::size_t size = regions_.points.size() - begin;
    if (size > 1 && regions_.points.back() == regions_.points[begin]) regions_.points.pop_back(), --size;
    if (size > 0) regions_.contour_ends.push_back(checked_index(begin + size, "vertices", most_vertices));
  }
  void end_polygon() {
    if (regions_.contour_ends.size() > contours_before_)
      regions_.polygon_ends.push_back(static_cast<std::uint32_t>(regions_.contour_ends.size()));
  }

  RegionSet take() { return std::move(regions_); }

 private:
  void make_room() {
    const std::size_t room = regions_.points.size() < 16 ? 16 : 2 * regions_.points.size();
    check_count(regions_.points.size(), "vertices", most_vertices);
    Charge charge(room * sizeof(Point));
    regions_.points.reserve(room);
    charge_ = std::move(charge);
  }

  RegionSet regions_;
  std::size_t contours_before_ = 0;
  Charge charge_;  ///< for the points, which take most of the memory
};

}  // namespace oblast::internal
