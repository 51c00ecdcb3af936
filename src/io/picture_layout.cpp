#include "io/picture_layout.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "io/picture_header.h"

namespace oblast::io {

namespace {

constexpr double footer = 46, gap = 34;
constexpr double tallest_panel = 820;

// What is drawn of the most vertices: where it is dense, it is enlarged.
RegionView largest_part(const Picture& picture) {
  RegionView largest = picture.result.points.empty() ? picture.a : picture.result;
  if (!picture.classes.empty()) largest = picture.classes.front().regions;  // the operands are not drawn
  for (const PictureClass& rows : picture.classes)
    if (rows.regions.points.size() > largest.points.size()) largest = rows.regions;
  if (picture.lines.vertices.size() > largest.points.size()) largest = {picture.lines.vertices, picture.lines.ends, {}};
  return largest;
}

// The marks that stand out.
std::vector<Point> largest_marks(const Picture& picture) {
  double size = 0;
  std::vector<Point> points;
  for (const PictureMarks& marks : picture.marks) {
    if (marks.size > size) points.clear();
    size = std::max(size, marks.size);
    if (marks.size == size) points.insert(points.end(), marks.points.begin(), marks.points.end());
  }
  return points;
}

}  // namespace

// The enlarged panel is below wide data and beside tall data.
Panels lay_out(const Picture& picture, const Window& window, double header) {
  double squeeze = 1;
  if (picture.projection == MapProjection::longitude_latitude) {
    const double latitude = std::clamp(window.y0 / 2 + window.y1 / 2, -85.0, 85.0);
    squeeze = std::cos(latitude * 3.14159265358979323846 / 180);
  }
  const double full = page_width - margin_left - margin_right;
  const double aspect = std::clamp(window.height() > 0 ? window.width() * squeeze / window.height() : 1e3, 0.2, 6.0);
  const Window padded{window.x0 - window.width() * 0.02, window.y0 - window.height() * 0.02,
                      window.x1 + window.width() * 0.02, window.y1 + window.height() * 0.02};
  const RegionView dense = largest_part(picture);
  const std::vector<Point> marked = largest_marks(picture);

  Panels panels;
  const Box alone{margin_left, header, full, std::min(tallest_panel, full / aspect)};
  panels.main = fit(padded, squeeze, alone);
  panels.page_height = header + alone.height + footer;
  const bool wide = aspect >= 1.7;
  const double half = (full - margin_left) / 2;
  const Box beside{margin_left + half + margin_left, header, half,
                   std::min(tallest_panel, std::max(half, half / aspect))};
  const Box below{margin_left, header + alone.height + gap, full, 560};
  const Box& zoom_box = wide ? below : beside;
  const std::optional<Window> enlarged =
      densest_window(dense, marked.empty() ? dense.points : std::span<const Point>(marked), panels.main, zoom_box);
  if (!enlarged) return panels;
  if (!wide) panels.main = fit(padded, squeeze, {margin_left, header, half, beside.height});
  panels.zoom = fit(*enlarged, squeeze, zoom_box);
  panels.page_height = zoom_box.top + zoom_box.height + footer;
  return panels;
}

}  // namespace oblast::io
