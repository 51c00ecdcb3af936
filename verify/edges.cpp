// The edges of a result, and their names in faults.
#include "verify/edges.h"

#include <array>
#include <charconv>

namespace oblast::verify {

Edges::Edges(const RegionView& view)
    : regions(view), next(view.points.size()), contour_of(view.points.size()), polygon_of(view.contour_count()) {
  for (std::uint32_t p = 0; p < view.polygon_count(); ++p) {
    for (std::uint32_t c = view.polygon_begin(p); c < view.polygon_end(p); ++c) polygon_of[c] = p;
  }
  for (std::uint32_t c = 0; c < view.contour_count(); ++c) {
    const std::uint32_t begin = view.contour_begin(c), end = view.contour_end(c);
    for (std::uint32_t v = begin; v < end; ++v) {
      next[v] = v + 1 == end ? begin : v + 1;
      contour_of[v] = c;
    }
  }
}

Place Edges::place_of(std::uint32_t vertex) const {
  const std::uint32_t contour = contour_of[vertex];
  return {Place::npos, polygon_of[contour], contour, vertex - regions.contour_begin(contour)};
}

Fault Edges::fault_at(std::uint32_t vertex, const std::string& what) const { return {what, place_of(vertex)}; }

std::string to_text(const Point& p) {
  const auto digits = [](double value) {
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return std::string(buffer.data(), end);
  };
  return "(" + digits(p.x) + ", " + digits(p.y) + ")";
}

}  // namespace oblast::verify
