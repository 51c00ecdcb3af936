// What the oracles of nearest objects share: the sites of a file of shapes, the places to be asked for, the answers.
//
//   places    u64 count, then by place f64 x, f64 y
//   answers   by place f64 x0, y0, x1, y1: the nearest site. A point is a segment whose ends are equal.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "buffers/shape_file.h"

namespace zones {

using buffers::Shapes;
using buffers::Xy;

/// A site with whole coordinates.
struct Site {
  std::int32_t x0, y0, x1, y1;

  bool is_point() const { return x0 == x1 && y0 == y1; }
  friend auto operator<=>(const Site&, const Site&) = default;
};

/// Each point and each segment of the shapes once; points that are ends of segments are left out.
/// REQUIRES, else an exception: coordinates are whole numbers below 2^30.
struct Sites {
  std::vector<Site> points, segments;

  explicit Sites(const Shapes& shapes) {
    std::size_t begin = 0;
    for (const std::uint64_t end : shapes.contour_ends) {
      for (std::size_t i = begin; i < end; ++i)
        add(shapes.region_points[i], shapes.region_points[i + 1 == end ? begin : i + 1]);
      begin = end;
    }
    begin = 0;
    for (const std::uint64_t end : shapes.line_ends) {
      for (std::size_t i = begin; i + 1 < end; ++i) add(shapes.line_points[i], shapes.line_points[i + 1]);
      begin = end;
    }
    for (const Xy& p : shapes.points) points.push_back({whole(p.x), whole(p.y), whole(p.x), whole(p.y)});
    std::vector<Site> ends;
    for (const Site& s : segments) ends.insert(ends.end(), {{s.x0, s.y0, s.x0, s.y0}, {s.x1, s.y1, s.x1, s.y1}});
    for (auto* sites : {&points, &segments, &ends}) {
      std::sort(sites->begin(), sites->end());
      sites->erase(std::unique(sites->begin(), sites->end()), sites->end());
    }
    std::erase_if(points, [&](const Site& p) { return std::binary_search(ends.begin(), ends.end(), p); });
  }

 private:
  static std::int32_t whole(double x) {
    if (x != std::floor(x) || !(std::abs(x) < 0x1p30))
      throw std::runtime_error("a coordinate is no small whole number");
    return static_cast<std::int32_t>(x);
  }
  void add(const Xy& a, const Xy& b) {
    const Site s{whole(a.x), whole(a.y), whole(b.x), whole(b.y)}, turned{s.x1, s.y1, s.x0, s.y0};
    if (!s.is_point()) segments.push_back(std::min(s, turned));
  }
};

inline std::vector<Xy> read_places(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::vector<std::uint64_t> count(1);
  buffers::transfer(in, count);
  std::vector<Xy> places(in ? count[0] : 0);
  buffers::transfer(in, places);
  if (!in) throw std::runtime_error(path + ": no file of places");
  return places;
}

/// The numbers of the places along a snake through squares, so that each is near to the one before.
inline std::vector<std::size_t> along_a_snake(const std::vector<Xy>& places) {
  Xy low{1e300, 1e300}, high{-1e300, -1e300};
  for (const Xy& p : places) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double squares = std::sqrt(static_cast<double>(places.size()) / 2) + 1;
  const double side = std::max({(high.x - low.x) / squares, (high.y - low.y) / squares, 1e-300});
  std::vector<std::pair<double, double>> keys;
  for (const Xy& p : places) {
    const double row = std::floor((p.y - low.y) / side);
    keys.emplace_back(row, std::fmod(row, 2) == 0 ? p.x : -p.x);
  }
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  return order;
}

/// The main function of an oracle: SHAPES PLACES ANSWERS. ask(sites) makes the diagram and returns a function that
/// gives the nearest Site of a place; places come in an order in which neighbours are near to each other.
template <class Ask>
int answer(int argc, char** argv, const Ask& ask) {
  try {
    if (argc != 4) throw std::runtime_error("usage: SHAPES PLACES ANSWERS");
    const Sites sites(buffers::read_shapes(argv[1]));
    const std::vector<Xy> places = read_places(argv[2]);
    auto nearest = ask(sites);
    std::vector<double> answers(4 * places.size());
    for (const std::size_t k : along_a_snake(places)) {
      const Site s = nearest(places[k]);
      const double numbers[] = {double(s.x0), double(s.y0), double(s.x1), double(s.y1)};
      std::copy(numbers, numbers + 4, answers.begin() + static_cast<std::ptrdiff_t>(4 * k));
    }
    std::ofstream out(argv[3], std::ios::binary);
    buffers::transfer(out, answers);
    if (!out) throw std::runtime_error(std::string(argv[3]) + ": cannot be written");
    std::printf("%zu\n", sites.points.size() + sites.segments.size());
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
}

}  // namespace zones
