#include "locate/inputs.h"

#include <oblast/measure.h>
#include <oblast/overlay.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verify/predicates.h"
#include "workloads/workloads.h"

namespace oblast::bench {
namespace {

std::vector<Point> circle(std::size_t vertices) {
  std::vector<Point> contour;
  for (std::size_t i = 0; i < vertices; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(vertices);
    contour.push_back({1000 * std::cos(angle), 1000 * std::sin(angle)});
  }
  return contour;
}

/// Koch's, of 3 4^level edges.
std::vector<Point> snowflake(std::size_t level) {
  const double c = std::sqrt(3.0) / 2;
  std::vector<Point> contour = {{0, 0}, {500, -1000 * c}, {-500, -1000 * c}};
  std::reverse(contour.begin(), contour.end());
  for (; level > 0; --level) {
    std::vector<Point> finer;
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Point a = contour[i], b = contour[(i + 1) % contour.size()];
      const Point third{(b.x - a.x) / 3, (b.y - a.y) / 3}, p{a.x + third.x, a.y + third.y};
      finer.insert(finer.end(), {a,
                                 p,
                                 {p.x + third.x / 2 + c * third.y, p.y + third.y / 2 - c * third.x},
                                 {a.x + 2 * third.x, a.y + 2 * third.y}});
    }
    contour = std::move(finer);
  }
  return contour;
}

Point in_bounds(const Box& b, std::mt19937_64& random) {
  const double x = uniform(random), y = uniform(random);
  return {b.x0 + (b.x1 - b.x0) * x, b.y0 + (b.y1 - b.y0) * y};
}

double moved(double value, std::uint64_t steps) {
  if (value == 0) return value;  // what is next to it is outside of the domain
  const double towards = steps % 2 == 0 ? INFINITY : -INFINITY;
  for (steps = steps / 2 % 5; steps > 0; --steps) value = std::nextafter(value, towards);
  return value;
}

}  // namespace

RegionSet regions_named(const std::string& name) {
  const std::size_t colon = name.find(':');
  const std::string kind = name.substr(0, colon);
  RegionSet regions;
  std::mt19937_64 random(1);
  if (colon != std::string::npos && (kind == "circle" || kind == "star" || kind == "snowflake")) {
    const std::size_t size = std::stoul(name.substr(colon + 1));
    add_polygon(regions, kind == "circle"      ? circle(size)
                         : kind == "snowflake" ? snowflake(size)
                                               : wiggly_star(static_cast<std::uint32_t>(size), 0, random));
  } else {
    regions = read_workload(name).a.arrays;
  }
  return unite(regions);
}

std::vector<Point> points_all_over(const RegionView& regions, std::size_t count) {
  std::mt19937_64 random(2);
  const Box box = *bounds(regions);
  std::vector<Point> points;
  while (points.size() < count) points.push_back(in_bounds(box, random));
  return points;
}

std::vector<Point> points_half_near_vertices(const RegionView& regions, std::size_t count) {
  std::mt19937_64 random(3);
  const Box box = *bounds(regions);
  std::vector<Point> points;
  while (points.size() < count) {
    if (points.size() % 2 == 0) {
      points.push_back(in_bounds(box, random));
      continue;
    }
    const std::size_t v = random() % regions.points.size();
    const Point a = regions.points[v], b = regions.points[v + 1 < regions.points.size() ? v + 1 : 0];
    const std::uint64_t first = random(), second = random();
    if (points.size() % 4 == 1) {
      points.push_back({moved(a.x, first), moved(a.y, second)});
    } else {
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      points.push_back({a.x + length * (static_cast<double>(first >> 11) * 0x1p-52 - 1),
                        a.y + length * (static_cast<double>(second >> 11) * 0x1p-52 - 1)});
    }
  }
  return points;
}

std::vector<Location> true_locations(const RegionView& regions, const std::vector<Point>& points) {
  struct Edge {
    Point p, q;
  };
  const Box box = *bounds(regions);
  constexpr std::size_t count = 1 << 13;
  const auto strip_of = [&](double y) {  // does not decrease, which is all that is needed of it
    const double part = (y - box.y0) / (box.y1 - box.y0) * count;
    return static_cast<std::size_t>(std::clamp(part, 0.0, count - 1.0));
  };
  std::vector<std::vector<Edge>> strips(count);
  for (const std::span<const Point> contour : regions.contours()) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Edge edge{contour[i], contour[i + 1 == contour.size() ? 0 : i + 1]};
      const auto [low, high] = std::minmax(edge.p.y, edge.q.y);
      for (std::size_t s = strip_of(low); s <= strip_of(high); ++s) strips[s].push_back(edge);
    }
  }
  std::vector<Location> locations;
  for (const Point& p : points) {
    bool inside = false, on = false;
    for (const Edge& e : strips[strip_of(p.y)]) {
      const auto [low, high] = std::minmax(e.p.y, e.q.y);
      const auto [left, right] = std::minmax(e.p.x, e.q.x);
      if (p.y < low || p.y > high || p.x > right) continue;
      if (p.x < left) {
        inside ^= (e.p.y <= p.y) != (e.q.y <= p.y);
        continue;
      }
      const int side = verify::side_of_line(e.p, e.q, p);
      on = on || side == 0;
      if ((e.p.y <= p.y) != (e.q.y <= p.y)) inside ^= (side > 0) == (e.p.y < e.q.y);
    }
    locations.push_back(on ? Location::boundary : inside ? Location::inside : Location::outside);
  }
  return locations;
}

}  // namespace oblast::bench
