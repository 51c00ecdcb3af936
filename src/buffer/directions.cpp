#include "buffer/directions.h"

#include <algorithm>
#include <cmath>

namespace oblast::internal::buffering {
namespace {

Point bisector(const Point& u, const Point& w) {
  const Point sum{u.x + w.x, u.y + w.y};
  const double length = std::sqrt(dot(sum, sum));
  return {sum.x / length, sum.y / length};
}

/// The quadrant of a vector, with the axis at which it begins.
std::size_t quadrant_of(const Point& u) {
  if (u.x > 0 && u.y >= 0) return 0;
  if (u.x <= 0 && u.y > 0) return 1;
  if (u.x < 0 && u.y <= 0) return 2;
  return 3;
}

/// Turned by so many quarters, counter-clockwise.
Point turned(const Point& u, std::size_t quarters) {
  switch (quarters & 3) {
    case 0:
      return u;
    case 1:
      return {-u.y, u.x};
    case 2:
      return {-u.x, -u.y};
    default:
      return {u.y, -u.x};
  }
}

}  // namespace

double Directions::cosine_of(std::size_t count) {
  double cosine = std::sqrt(0.5);
  for (std::size_t directions = 4; directions < count; directions *= 2) cosine = std::sqrt((1 + cosine) / 2);
  return cosine;
}

int Directions::level_for(double cosine) {
  int level = 1;
  while (level < most_levels && cosine_of(std::size_t{4} << level) < cosine) ++level;
  return level;
}

Directions::Directions(int level) : quarter_(std::size_t{1} << level), first_quadrant_(quarter_ + 1) {
  first_quadrant_.front() = {1, 0};
  first_quadrant_.back() = {0, 1};
  for (std::size_t step = quarter_; step > 1; step /= 2)
    for (std::size_t k = step / 2; k < quarter_; k += step) {
      // The second half mirrors the first, so that the grid has all symmetries of the axes.
      const Point mirrored = first_quadrant_[quarter_ - k];
      first_quadrant_[k] = 2 * k > quarter_ ? Point{mirrored.y, mirrored.x}
                                            : bisector(first_quadrant_[k - step / 2], first_quadrant_[k + step / 2]);
    }
}

Point Directions::operator[](std::size_t k) const {
  k %= count();
  return turned(first_quadrant_[k % quarter_], k / quarter_);
}

std::size_t Directions::first_after(const Point& u) const {
  const std::size_t quadrant = quadrant_of(u);
  const Point in_first = turned(u, 4 - quadrant);
  const auto after = std::partition_point(first_quadrant_.begin(), first_quadrant_.end() - 1,
                                          [&](const Point& g) { return !(cross(in_first, g) > 0); });
  return quadrant * quarter_ + static_cast<std::size_t>(after - first_quadrant_.begin());
}

std::size_t Directions::last_before(const Point& u) const {
  const std::size_t quadrant = quadrant_of(u);
  const Point in_first = turned(u, 4 - quadrant);
  const auto not_before = std::partition_point(first_quadrant_.begin(), first_quadrant_.end() - 1,
                                               [&](const Point& g) { return cross(in_first, g) < 0; });
  return quadrant * quarter_ + static_cast<std::size_t>(not_before - first_quadrant_.begin()) + count() - 1;
}

Directions::Range Directions::between(const Point& from, const Point& to) const {
  const std::size_t first = first_after(from), last = last_before(to);
  const std::size_t many = (last + count() + 1 - first) % count();
  // More than half a turn means that there is none between: the last one is before the first.
  return {first, many > count() / 2 + 1 ? 0 : many};
}

}  // namespace oblast::internal::buffering
