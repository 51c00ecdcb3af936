#include "overlay/validate.h"

#include <oblast/domain.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>

#include "base/parallel.h"
#include "base/tuning.h"

namespace oblast {
namespace {

void check_offsets(const RegionView& v, std::size_t operand) {
  const auto check = [&](std::span<const std::uint32_t> ends, std::size_t size, const char* name) {
    const bool increasing = std::is_sorted(ends.begin(), ends.end());
    if (!increasing || (!ends.empty() && ends.back() != size) || (ends.empty() && size != 0))
      throw Error(ErrorCode::bad_offsets,
                  std::string(name) + " must not decrease and must end at " + std::to_string(size), {operand});
  };
  if (v.points.size() >= 0x7fffffff)
    throw Error(ErrorCode::too_large, "more than 2^31 - 1 vertices in one call", {operand});
  check(v.contour_ends, v.points.size(), "contour_ends");
  if (!v.polygon_ends.empty()) check(v.polygon_ends, v.contour_ends.size(), "polygon_ends");
}

[[noreturn]] void throw_at(const RegionView& v, std::size_t operand, std::size_t vertex) {
  const auto contour = static_cast<std::size_t>(std::upper_bound(v.contour_ends.begin(), v.contour_ends.end(), vertex) -
                                                v.contour_ends.begin());
  const auto polygon =
      v.polygon_ends.empty()
          ? contour
          : static_cast<std::size_t>(std::upper_bound(v.polygon_ends.begin(), v.polygon_ends.end(), contour) -
                                     v.polygon_ends.begin());
  const Point& p = v.points[vertex];
  const bool finite = std::isfinite(p.x) && std::isfinite(p.y);
  throw Error(finite ? ErrorCode::out_of_domain : ErrorCode::not_finite,
              finite ? "coordinate outside the domain: its magnitude must be 0 or between 2^-300 and 2^300"
                     : "coordinate is not a finite number",
              {operand, polygon, contour, vertex - v.contour_begin(contour)});
}

}  // namespace

void validate(const RegionView& operand, std::size_t operand_index) {
  check_offsets(operand, operand_index);
  const auto is_good = [](const Point& p) { return in_domain(p.x) && in_domain(p.y); };
  const std::span points = operand.points;
  std::atomic<bool> all_good = true;
  for_ranges(points.size(), tuning::validated_points_a_range, [&](std::size_t begin, std::size_t end) {
    if (!std::all_of(points.begin() + begin, points.begin() + end, is_good)) all_good = false;
  });
  if (all_good) return;
  const auto bad = std::find_if_not(points.begin(), points.end(), is_good);
  throw_at(operand, operand_index, static_cast<std::size_t>(bad - points.begin()));
}

}  // namespace oblast
