#include "regions/validate.h"

#include <oblast/domain.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>

#include "base/index.h"
#include "base/parallel.h"
#include "base/tuning.h"

namespace oblast::internal {
namespace {

void check_offsets(const RegionView& v, std::size_t operand) {
  const auto check = [&](std::span<const std::uint32_t> ends, std::size_t first, std::size_t size, const char* name) {
    const bool increasing = std::is_sorted(ends.begin(), ends.end()) && (ends.empty() || ends.front() >= first);
    if (!increasing || (!ends.empty() && ends.back() != first + size) || (ends.empty() && size != 0))
      throw Error(ErrorCode::bad_offsets,
                  std::string(name) + " must not decrease and must end at " + std::to_string(first + size), {operand});
  };
  // The sizes are checked before anything is read.
  const auto check_size = [&](std::size_t count, const char* what, std::size_t most) {
    if (count > most) throw_too_many(what, most, operand);
  };
  check_size(v.points.size(), "vertices in one call", most_vertices);
  check_size(v.contour_count(), "contours in one call", most_indices);
  check_size(v.polygon_count(), "polygons in one call", most_indices);
  check(v.contour_ends, v.first_point, v.points.size(), "contour_ends");
  if (!v.polygon_ends.empty()) check(v.polygon_ends, v.first_contour, v.contour_count(), "polygon_ends");
}

[[noreturn]] void throw_at(const Point& p, const Place& place) {
  throw_bad_coordinate(std::isfinite(p.x) && std::isfinite(p.y), place);
}

Place place_of(const RegionView& v, std::size_t operand, std::size_t vertex) {
  const auto index_of = [](std::span<const std::uint32_t> ends, std::size_t i) {
    return static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), i) - ends.begin());
  };
  const std::size_t contour = index_of(v.contour_ends, v.first_point + vertex);
  const std::size_t polygon = v.polygon_ends.empty() ? contour : index_of(v.polygon_ends, v.first_contour + contour);
  return {operand, polygon, contour, vertex - v.contour_begin(contour)};
}

/// The index of the first point that is not in the domain; the number of points if all are.
std::size_t first_bad(std::span<const Point> points) {
  const auto is_good = [](const Point& p) { return in_domain(p.x) && in_domain(p.y); };
  std::atomic<bool> all_good = true;
  for_ranges(points.size(), tuning::validated_points_a_range, [&](std::size_t begin, std::size_t end) {
    if (!std::all_of(points.begin() + begin, points.begin() + end, is_good)) all_good = false;
  });
  if (all_good) return points.size();
  return static_cast<std::size_t>(std::find_if_not(points.begin(), points.end(), is_good) - points.begin());
}

}  // namespace

void throw_bad_coordinate(bool finite, const Place& place, const std::string& where) {
  throw Error(finite ? ErrorCode::out_of_domain : ErrorCode::not_finite,
              (finite ? "coordinate outside the domain: its magnitude must be 0 or between 2^-300 and 2^300"
                      : "coordinate is not a finite number") +
                  where,
              place);
}

void validate(const RegionView& operand, std::size_t operand_index) {
  check_offsets(operand, operand_index);
  const std::size_t bad = first_bad(operand.points);
  if (bad < operand.points.size()) throw_at(operand.points[bad], place_of(operand, operand_index, bad));
}

void validate(std::span<const Point> contour) {
  const std::size_t bad = first_bad(contour);
  if (bad < contour.size()) throw_at(contour[bad], {0, 0, 0, bad});
}

}  // namespace oblast::internal
