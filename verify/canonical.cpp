// Checks the canonical form (G3): the first vertex of each contour, and the order of contours and polygons.
#include <algorithm>
#include <cmath>
#include <span>

#include "verify/edges.h"

namespace oblast::verify {
namespace {

using Contour = std::span<const Point>;

// Compares contours as sequences of vertices; `shift` rotates the first.
bool sequence_less(Contour a, std::size_t shift, Contour b) {
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const Point& p = a[(i + shift) % a.size()];
    if (p != b[i]) return lexicographically_less(p, b[i]);
  }
  return a.size() < b.size();
}

std::optional<std::string> check_start(Contour contour) {
  for (std::size_t v = 1; v < contour.size(); ++v) {
    if (lexicographically_less(contour[v], contour[0])) {
      return "the contour starts at " + to_text(contour[0]) + ", not at its smallest vertex " + to_text(contour[v]);
    }
    if (contour[v] == contour[0] && sequence_less(contour, v, contour)) {
      return "the contour visits its smallest vertex " + to_text(contour[0]) +
             " repeatedly and starts at the wrong pass";
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Fault> check_canonical(const RegionView& regions) {
  const Edges edges(regions);
  for (std::uint32_t v = 0; v < edges.size(); ++v) {
    const Point p = edges.from(v);
    if ((p.x == 0 && std::signbit(p.x)) || (p.y == 0 && std::signbit(p.y))) {
      return edges.fault_at(v, "a coordinate is negative zero");
    }
  }
  for (std::size_t c = 0; c < regions.contour_count(); ++c) {
    if (auto what = check_start(regions.contour(c))) return edges.fault_at(regions.contour_begin(c), *what);
  }
  for (std::size_t p = 0; p < regions.polygon_count(); ++p) {
    const std::size_t first = regions.polygon_begin(p), end = regions.polygon_end(p);
    if (p > 0 && !sequence_less(regions.contour(regions.polygon_begin(p - 1)), 0, regions.contour(first))) {
      return edges.fault_at(regions.contour_begin(first), "polygons are not ordered by their outer contours");
    }
    for (std::size_t c = first + 2; c < end; ++c) {
      if (!sequence_less(regions.contour(c - 1), 0, regions.contour(c))) {
        return edges.fault_at(regions.contour_begin(c), "the holes of the polygon are not in order");
      }
    }
  }
  return std::nullopt;
}

}  // namespace oblast::verify
