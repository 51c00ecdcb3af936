// The hull: corners are input vertices, turn left strictly, start at the smallest, and no vertex lies outside.
#include <oblast/hull.h>

#include <algorithm>

#include "bytes_to_operands.h"
#include "verify/predicates.h"

namespace {

using namespace oblast;

const char* fault_of(std::span<const Point> corners, std::span<const Point> points) {
  const std::size_t n = corners.size();
  for (const Point& p : corners) {
    if (std::find(points.begin(), points.end(), p) == points.end()) return "a corner from nowhere";
    if (lexicographically_less(p, corners[0])) return "it does not start at the smallest corner";
  }
  if (n < 3) return nullptr;
  for (std::size_t i = 0; i < n; ++i) {
    const Point &p = corners[i], &q = corners[(i + 1) % n];
    if (verify::side_of_line(p, q, corners[(i + 2) % n]) <= 0) return "it does not turn left";
    for (const Point& r : points)
      if (verify::side_of_line(p, q, r) < 0) return "a vertex lies outside";
  }
  return nullptr;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const fuzz::Input input = fuzz::input_from(bytes, size);
  const RegionView a = input.operands.a;
  const auto check = [&](std::span<const Point> corners, std::span<const Point> points) {
    if (const char* what = fault_of(corners, points))
      fuzz::report({generators::Broken::wrong, Operation::unite, what}, input);
  };
  for (std::size_t c = 0; c < a.contour_count(); ++c) check(hull(a.contour(c)), a.contour(c));
  check(hull(a).points, a.points);
  return 0;
}
