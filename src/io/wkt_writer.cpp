// Writes Well-Known Text.
#include "io/number_text.h"
#include "io/write.h"

namespace oblast::io {

namespace {

void append_contour(std::string& text, std::span<const Point> contour) {
  const auto append_point = [&](const Point& p) {
    append_number(text, p.x);
    text += ' ';
    append_number(text, p.y);
  };
  text += '(';
  for (const Point& p : contour) {
    append_point(p);
    text += ", ";
  }
  append_point(contour.front());
  text += ')';
}

}  // namespace

std::string to_wkt(const RegionView& regions) {
  constexpr std::size_t typical_vertex_length = 38;
  std::string text;
  text.reserve(regions.points.size() * typical_vertex_length + 32);
  for (std::size_t p = 0; p < regions.polygon_count(); ++p) {
    bool first_ring = true;
    for (std::size_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c) {
      if (regions.contour(c).empty()) continue;
      if (first_ring) text += text.empty() ? "MULTIPOLYGON ((" : ", (";
      if (!first_ring) text += ", ";
      append_contour(text, regions.contour(c));
      first_ring = false;
    }
    if (!first_ring) text += ')';
  }
  return text.empty() ? "POLYGON EMPTY" : text + ')';
}

}  // namespace oblast::io
