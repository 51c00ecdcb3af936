#include "hull/simple_polygons.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "exact/orientation.h"

namespace oblast::tests {
using namespace internal;
namespace {

constexpr double pi = std::numbers::pi;

Point polar(double angle, double radius) { return {radius * std::cos(angle), radius * std::sin(angle)}; }

/// A tree over the nodes of a w x h lattice as a bitmap of (2w + 1) x (2h + 1) cells, its margin empty.
class TreeCells {
 public:
  TreeCells(Random& random, int w, int h) : width_(2 * w + 1), cells_(static_cast<std::size_t>(width_ * (2 * h + 1))) {
    std::vector<std::pair<int, int>> path{{random.below(w), random.below(h)}};
    set(2 * path[0].first + 1, 2 * path[0].second + 1);
    while (!path.empty()) {
      const auto [x, y] = path.back();
      constexpr int dx[] = {1, 0, -1, 0}, dy[] = {0, 1, 0, -1};
      int open[4], count = 0;
      for (int d = 0; d < 4; ++d) {
        const int u = x + dx[d], v = y + dy[d];
        if (u >= 0 && v >= 0 && u < w && v < h && !at(2 * u + 1, 2 * v + 1)) open[count++] = d;
      }
      if (count == 0) {
        path.pop_back();
        continue;
      }
      const int d = open[random.below(count)];
      set(2 * x + 1 + dx[d], 2 * y + 1 + dy[d]);
      set(2 * (x + dx[d]) + 1, 2 * (y + dy[d]) + 1);
      path.emplace_back(x + dx[d], y + dy[d]);
    }
  }

  bool at(int x, int y) const { return cells_[static_cast<std::size_t>(y * width_ + x)]; }
  void set(int x, int y) { cells_[static_cast<std::size_t>(y * width_ + x)] = true; }

 private:
  int width_;
  std::vector<bool> cells_;
};

}  // namespace

std::vector<Point> star(Random& random, int n) {
  std::vector<double> angles(static_cast<std::size_t>(n));
  for (double& a : angles) a = random.in(0, 2 * pi);
  std::sort(angles.begin(), angles.end());
  const double inner = random.one_in(2) ? 0.95 : 0.05;
  std::vector<Point> ring;
  for (const double a : angles) {
    const Point p = polar(a, random.in(inner, 1));
    // Strictly left of the previous ray, so rounding cannot make the contour cross itself.
    if (ring.empty() || (exact::orientation({0, 0}, ring.back(), p) > 0)) ring.push_back(p);
  }
  while (ring.size() >= 3 && exact::orientation({0, 0}, ring.back(), ring[0]) <= 0) ring.pop_back();
  if (ring.size() < 3) return {{0, 0}, {1, 0}, {0, 1}};
  return ring;
}

std::vector<Point> monotone(Random& random, int n) {
  std::vector<double> xs(static_cast<std::size_t>(n));
  for (double& x : xs) x = random.one_in(2) ? random.below(n) : random.in(0, n);
  std::sort(xs.begin(), xs.end());
  xs.erase(std::unique(xs.begin(), xs.end()), xs.end());
  if (xs.size() < 3) return {{0, 0}, {1, 0}, {0, 1}};
  std::vector<Point> lower{{xs.front(), 0}}, upper;
  for (std::size_t i = 1; i + 1 < xs.size(); ++i) {
    if (random.one_in(2))
      lower.push_back({xs[i], random.in(-1, -0.1) * n});
    else
      upper.push_back({xs[i], random.in(0.1, 1) * n});
  }
  lower.push_back({xs.back(), 0});
  lower.insert(lower.end(), upper.rbegin(), upper.rend());
  return lower;
}

std::vector<Point> spiral(Random& random, int n) {
  const int half = std::max(n / 2, 3), a_turn = random.between(7, 20);
  const double pitch = 1, width = random.in(0.1, 0.6), start = random.in(0, 2 * pi);
  std::vector<Point> ring, back;
  for (int i = 0; i < half; ++i) {
    const double turns = static_cast<double>(i) / a_turn, angle = start + 2 * pi * turns;
    const double radius = pitch * (1 + turns);
    ring.push_back(polar(angle, radius));
    back.push_back(polar(angle, radius - width * pitch));
  }
  ring.insert(ring.end(), back.rbegin(), back.rend());
  return ring;
}

std::vector<Point> maze(Random& random, int n) {
  // About 1.9 corners a node.
  const int side = std::max(2, static_cast<int>(std::sqrt(n / 1.9)));
  const int w = side, h = std::max(2, side + random.between(-1, 1));
  const TreeCells cells(random, w, h);
  // The outline with the cells on its left, from the lower side of the lowest cell.
  int x = 0, y = 1;
  while (!cells.at(x, y)) ++x;
  const int x0 = x, y0 = y;
  int dx = 1, dy = 0;
  std::vector<Point> ring;
  do {
    // The corner reached: the cells left and right of a further step.
    x += dx;
    y += dy;
    const int left_x = dx > 0 ? x : dx < 0 ? x - 1 : dy > 0 ? x - 1 : x;
    const int left_y = dy > 0 ? y : dy < 0 ? y - 1 : dx > 0 ? y : y - 1;
    const int right_x = dx > 0 ? x : dx < 0 ? x - 1 : dy > 0 ? x : x - 1;
    const int right_y = dy > 0 ? y : dy < 0 ? y - 1 : dx > 0 ? y - 1 : y;
    if (cells.at(right_x, right_y)) {
      ring.push_back({static_cast<double>(x), static_cast<double>(y)});
      const int t = dx;
      dx = dy;
      dy = -t;
    } else if (!cells.at(left_x, left_y)) {
      ring.push_back({static_cast<double>(x), static_cast<double>(y)});
      const int t = dx;
      dx = -dy;
      dy = t;
    } else if (random.one_in(4)) {
      ring.push_back({static_cast<double>(x), static_cast<double>(y)});  // a straight vertex
    }
  } while (x != x0 || y != y0 || dx != 1);
  return ring;
}

std::vector<Point> comb(Random& random, int n) {
  const int teeth = std::max(1, n / 4);
  std::vector<Point> ring{{0, 0}, {2.0 * teeth, 0}};
  for (int i = teeth; i-- > 0;) {
    const double height = random.one_in(3) ? 10 : random.in(1, 20), x = 2.0 * i;
    // A tooth from x to x + 1, leaning, between gaps of height 0.5.
    const double lean = random.in(-0.4, 0.4);
    ring.push_back({x + 1.5, 0.5});
    ring.push_back({x + 1 + lean, height});
    ring.push_back({x + 0.5, 0.5});
  }
  return ring;
}

std::vector<Point> collinear_runs(Random& random, int n) {
  const int corners = std::max(4, n / 4);
  std::vector<Point> ring = random.one_in(2) ? maze(random, corners) : comb(random, corners);
  for (Point& p : ring) p = {8 * std::round(p.x * 16), 8 * std::round(p.y * 16)};
  std::vector<Point> result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
    result.push_back(p);
    // Eighths of an edge between multiples of eight are exact.
    for (int k = 1; k < 8; ++k)
      if (random.one_in(3)) result.push_back({p.x + k * ((q.x - p.x) / 8), p.y + k * ((q.y - p.y) / 8)});
  }
  return result;
}

std::vector<Point> moved_about(Random& random, std::vector<Point> ring) {
  const int quarters = random.below(4);
  const bool mirrored = random.one_in(2);
  for (Point& p : ring) {
    if (mirrored) p.x = -p.x;
    for (int i = 0; i < quarters; ++i) p = {-p.y, p.x};
  }
  if (random.one_in(2)) std::reverse(ring.begin(), ring.end());
  std::rotate(ring.begin(), ring.begin() + random.below(static_cast<int>(ring.size())), ring.end());
  return ring;
}

std::span<const SimpleKind> simple_kinds() {
  static constexpr SimpleKind kinds[] = {{"star", star}, {"monotone", monotone}, {"spiral", spiral},
                                         {"maze", maze}, {"comb", comb},         {"collinear runs", collinear_runs}};
  return kinds;
}

}  // namespace oblast::tests
