#include "verify/buffer_reference.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "verify/edges.h"
#include "verify/slabs.h"

namespace oblast::verify {
namespace {

constexpr int sides = 8;
constexpr double pi = 3.14159265358979323846;
constexpr double margin = 0x1p-20;  // more than the rounding of the sums' vertices

/// Polygons that overlap: the sums of segments with one octagon.
class Sums {
 public:
  explicit Sums(double radius) : radius_(radius) {}

  void add(const Point& a, const Point& b) {
    const double x = b.x - a.x, y = b.y - a.y;
    Point corners[sides];
    int leftmost = 0, rightmost = 0;
    const auto across = [&](int i) { return x * corners[i].y - y * corners[i].x; };
    for (int i = 0; i < sides; ++i) {
      corners[i] = {radius_ * std::cos(2 * pi * i / sides), radius_ * std::sin(2 * pi * i / sides)};
      if (across(i) > across(leftmost)) leftmost = i;
      if (across(i) < across(rightmost)) rightmost = i;
    }
    // Around b from the corner furthest to the right to the one furthest to the left, then on around a. Of a point all
    // corners are as far to either side.
    if (a == b) leftmost = rightmost;
    add_corners(b, corners, rightmost, (leftmost - rightmost + sides) % sides);
    add_corners(a, corners, leftmost, (rightmost - leftmost + sides - 1) % sides + 1);
    sums_.contour_ends.push_back(static_cast<std::uint32_t>(sums_.points.size()));
    sums_.polygon_ends.push_back(static_cast<std::uint32_t>(sums_.contour_ends.size()));
  }

  void add_all(const ZoneOf& shapes) {
    for (std::size_t c = 0; c < shapes.regions.contour_count(); ++c) {
      const std::span<const Point> contour = shapes.regions.contour(c);
      for (std::size_t i = 0; i < contour.size(); ++i) add(contour[i], contour[(i + 1) % contour.size()]);
    }
    for (const ZoneOf::Segment& segment : shapes.segments) add(segment.a, segment.b);
  }

  Operand operand() const { return {sums_, FillRule::polygons()}; }

 private:
  /// `steps` and one more.
  void add_corners(const Point& around, std::span<const Point> corners, int first, int steps) {
    for (int k = 0; k <= steps; ++k) {
      const Point& corner = corners[static_cast<std::size_t>((first + k) % sides)];
      sums_.points.push_back({around.x + corner.x, around.y + corner.y});
    }
  }

  double radius_;
  RegionSet sums_;
};

struct Membership {
  bool zone, regions, near, within;  ///< of the result, of the regions, of the sums by the lower and by the upper bound
};

double largest_of(const ZoneOf& shapes) {
  double largest = 0;
  for (const Point& p : shapes.regions.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  for (const auto& [a, b] : shapes.segments)
    largest = std::max({largest, std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
  return largest;
}

template <class IsWrong>
std::optional<Fault> check(const RegionView& zone, const ZoneOf& shapes, const ZoneBounds& bounds,
                           const IsWrong& is_wrong) {
  if (!(bounds.lower > largest_of(shapes) * 0x1p-33)) return std::nullopt;
  Sums near(bounds.lower * (1 - margin)), within(bounds.upper * (1 + margin) / std::cos(pi / sides));
  near.add_all(shapes);
  within.add_all(shapes);
  const std::vector<Operand> operands{
      {zone, FillRule::even_odd()}, {shapes.regions, FillRule::even_odd()}, near.operand(), within.operand()};
  std::optional<RationalPoint> wrong;
  for_each_trapezoid(operands, [&](const Trapezoid& t) {
    if (!wrong && is_wrong(Membership{t.inside[0], t.inside[1], t.inside[2], t.inside[3]})) wrong = t.centre();
  });
  if (!wrong) return std::nullopt;
  const Point p{round_to_nearest(wrong->x), round_to_nearest(wrong->y)};
  return Fault{"around " + to_text(p) + " the zone is not between its references", {}};
}

}  // namespace

std::optional<Fault> check_references(const RegionView& zone, const ZoneOf& shapes, const ZoneBounds& bounds) {
  return check(zone, shapes, bounds, [](const Membership& in) {
    return ((in.regions || in.near) && !in.zone) || (in.zone && !in.regions && !in.within);
  });
}

std::optional<Fault> check_inner_references(const RegionView& zone, const ZoneOf& shapes, const ZoneBounds& bounds) {
  return check(zone, shapes, bounds, [](const Membership& in) {
    return (in.zone && (in.near || !in.regions)) || (in.regions && !in.within && !in.zone);
  });
}

}  // namespace oblast::verify
