// The geometry of the tests for which iOverlay publishes figures (iShape-Rust/iOverlay, folder `performance`), written
// from their description. Coordinates are integers if theirs are.
#include <cmath>
#include <numbers>

#include "workloads/workloads.h"

namespace oblast::bench {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

// n x n squares of the given side, `step` apart.
RegionSet square_grid(double origin, double side, double step, std::uint32_t n) {
  RegionSet regions;
  for (std::uint32_t row = 0; row < n; ++row) {
    for (std::uint32_t column = 0; column < n; ++column) {
      const double x = origin + step * column;
      const double y = origin + step * row;
      add_rectangle(regions, x, y, x + side, y + side);
    }
  }
  return regions;
}

Workload checkerboard(std::uint32_t n, std::uint64_t) {
  return single(Operation::symmetric_difference, square_grid(0, 20, 30, n), square_grid(15, 20, 30, n - 1));
}

Workload not_overlap(std::uint32_t n, std::uint64_t) {
  return single(Operation::unite, square_grid(0, 10, 30, n), square_grid(15, 10, 30, n - 1));
}

Workload lines_net(std::uint32_t n, std::uint64_t) {
  RegionSet vertical, horizontal;
  const double half = 10.0 * n;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double from = 20.0 * i - half + 5;
    add_rectangle(vertical, from, -half, from + 10, half);
    add_rectangle(horizontal, -half, from - 10, half, from);
  }
  return single(Operation::intersection, std::move(vertical), std::move(horizontal));
}

// A band along a zigzag that winds outwards. Neighbouring turns of the band cross.
Workload spiral(std::uint32_t n, std::uint64_t) {
  constexpr double unit = 100;
  constexpr double width = 0.1 * unit;
  std::vector<Point> left, right;
  double angle = 0;
  double radius = unit;
  Point from = {0, 0};
  for (std::uint32_t i = 0; i < n; ++i) {
    const double r = i % 2 == 0 ? radius + 0.2 * unit : radius - 0.2 * unit;
    const Point to = {r * std::cos(angle), r * std::sin(angle)};
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    const Point normal = {-(to.y - from.y) / length * width, (to.x - from.x) / length * width};
    for (const Point& p : {from, to}) {
      left.push_back({p.x + normal.x, p.y + normal.y});
      right.push_back({p.x - normal.x, p.y - normal.y});
    }
    angle += unit / radius;
    radius = unit * (1 + angle / two_pi);
    from = to;
  }
  left.insert(left.end(), right.rbegin(), right.rend());
  RegionSet regions;
  add_polygon(regions, left);
  return single(Operation::unite, std::move(regions), {}, OperandKind::crossing, OperandKind::region_set,
                FillRule::Kind::nonzero);
}

Workload windows(std::uint32_t n, std::uint64_t) {
  const double origin = -15.0 * n;
  return single(Operation::difference, square_grid(origin, 20, 30, n), square_grid(origin + 5, 10, 30, n));
}

// Frames of width 4 around a common centre. One operand has their horizontal sides, the other the vertical ones.
Workload nested_squares(std::uint32_t n, std::uint64_t) {
  constexpr double width = 4;
  RegionSet vertical, horizontal;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double r = 2 * width * (i + 1);
    add_rectangle(horizontal, -r, r - width, r, r);
    add_rectangle(horizontal, -r, -r, r, width - r);
    add_rectangle(vertical, -r, -r, width - r, r);
    add_rectangle(vertical, r - width, -r, r, r);
  }
  return single(Operation::symmetric_difference, std::move(vertical), std::move(horizontal));
}

std::vector<Point> regular_polygon(Point center, double radius, double turn, std::uint32_t sides) {
  std::vector<Point> contour;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = turn + two_pi * i / sides;
    contour.push_back({center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)});
  }
  return contour;
}

Workload corrosion(std::uint32_t n, std::uint64_t) {
  const auto grid = [](double origin, double step, double radius, std::uint32_t count) {
    RegionSet regions;
    for (std::uint32_t row = 0; row < count; ++row) {
      for (std::uint32_t column = 0; column < count; ++column) {
        const Point center = {origin + step * column, origin + step * row};
        add_polygon(regions, regular_polygon(center, radius, 0, (row + column) % 5 + 3));
      }
    }
    return regions;
  };
  const auto bites = static_cast<std::uint32_t>(std::lround(2.5 * n));
  return single(Operation::difference, grid(0, 100, 40, n), grid(-40, 40, 16, bites));
}

Workload concentric(std::uint32_t n, std::uint64_t) {
  constexpr double unit = 100;
  RegionSet rings, beads;
  double radius = unit;
  double turn = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    add_polygon(rings, regular_polygon({0, 0}, radius + unit, turn, i + 3));
    add_hole(rings, regular_polygon({0, 0}, radius, turn, i + 3));
    const double count = two_pi * radius * 0.8 / unit;
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(count); ++j) {
      const double angle = turn + two_pi * j / count;
      add_polygon(beads, regular_polygon({radius * std::cos(angle), radius * std::sin(angle)}, unit / 2, 0, j % 5 + 3));
    }
    radius += 2 * unit;
    turn += 0.05;
  }
  return single(Operation::intersection, std::move(rings), std::move(beads));
}

// Each cell has four triangles like the sails of a windmill, and four squares that overlap them.
Workload windmill(std::uint32_t n, std::uint64_t) {
  RegionSet sails, bites;
  for (std::uint32_t row = 0; row < n; ++row) {
    for (std::uint32_t column = 0; column < n; ++column) {
      const auto at = [&](double x, double y) { return Point{40 + 80.0 * column + 10 * x, 40 + 80.0 * row + 10 * y}; };
      const auto sail = [&](Point p, Point q, Point r) {
        const Point corners[] = {p, q, r};
        add_polygon(sails, corners);
      };
      sail(at(0, 0), at(-3, 0), at(0, 3));
      sail(at(0, 1), at(0, 4), at(3, 1));
      sail(at(1, 0), at(1, -3), at(-2, 0));
      sail(at(1, 1), at(4, 1), at(1, -2));
      for (const Point& corner : {at(-3, 1), at(1, 2), at(-2, -3), at(2, -2)}) {
        add_rectangle(bites, corner.x, corner.y, corner.x + 20, corner.y + 20);
      }
    }
  }
  return single(Operation::difference, std::move(sails), std::move(bites), OperandKind::overlapping,
                OperandKind::overlapping);
}

constexpr NamedWorkload workloads[] = {
    {"checkerboard", "squares a side", checkerboard},
    {"not_overlap", "squares a side", not_overlap},
    {"lines_net", "bars in each of the two directions", lines_net},
    {"spiral", "turning points of the band", spiral},
    {"windows", "windows a side", windows},
    {"nested_squares", "frames", nested_squares},
    {"corrosion", "polygons a side", corrosion},
    {"concentric", "rings", concentric},
    {"windmill", "mills a side", windmill},
};

}  // namespace

std::span<const NamedWorkload> ioverlay_workloads() { return workloads; }

}  // namespace oblast::bench
