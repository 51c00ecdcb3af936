// A point of the plane.
#pragma once

namespace oblast {

/// A point: two finite IEEE 754 doubles. They are compared by value, so -0.0 equals 0.0.
struct Point {
  double x = 0;
  double y = 0;

  friend constexpr bool operator==(const Point&, const Point&) = default;
};

/// Lexicographic order: by x, then by y. Canonical results are sorted by it.
constexpr bool lexicographically_less(const Point& p, const Point& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

}  // namespace oblast
