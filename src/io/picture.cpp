// The layout of a picture: title, legend, the main panel, and an enlarged panel if it is needed.
//
//     title
//     [A] fires: 20,634 contours   [ ] union: 12,841 contours      legend
//     +--------------------------------------------+
//     | main panel                     [zoom]      |               flat data: the enlarged panel below;
//     +--------------------------------------------+               else beside
//     +--------------------------------------------+
//     | the window marked above, enlarged          |
//     +--------------------------------------------+
//     note on what is not drawn as it is
//
// The operands are pale, and the result lies on them in a strong colour. So the answer is seen in every operation, also
// where it has the same outlines as an operand.
#include "io/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "io/picture_axes.h"
#include "io/picture_contours.h"
#include "io/picture_frame.h"
#include "io/picture_header.h"
#include "io/picture_marks.h"
#include "io/picture_text.h"

namespace oblast::io {

namespace {

constexpr double footer = 46, gap = 34;
constexpr double tallest_panel = 820;
constexpr std::size_t bytes_of_classes = 1'400'000;  // in one panel
constexpr const char* colour_zoom = "#c53030";

struct Panels {
  Frame main;
  std::optional<Frame> zoom;
  double page_height = 0;
};

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

// The panels for data of this extent. The enlarged panel is below wide data and beside tall data.
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

struct Style {
  const char* fill;
  double opacity;
  const char* stroke;
  double stroke_width;  // pixels; 0: none
};

// Contours that are larger than a pixel in one group, the rest as dots.
std::string draw_filled(const DrawnContours& drawn, const Style& style) {
  const std::string stroke = style.stroke_width > 0
                                 ? fmt::format("stroke=\"{}\" stroke-width=\"{:.0f}\" stroke-linejoin=\"round\"",
                                               style.stroke, style.stroke_width * 10)
                                 : "stroke=\"none\"";
  return fmt::format(
      "<g fill=\"{}\" fill-opacity=\"{}\" fill-rule=\"evenodd\" {} transform=\"scale(0.1)\">\n{}{}</g>\n", style.fill,
      style.opacity, stroke, drawn.polygons, drawn.dots);
}

struct DrawnPanel {
  std::string text;
  std::uint64_t gathered = 0;
  std::uint64_t left_out = 0;
};

// `line` is the width of outlines in pixels; 0 where edges are too short to be seen, and would make a dark blot.
DrawnPanel draw_panel(const Picture& picture, const Frame& frame, const std::string& clip, double line) {
  const Box& box = frame.box;
  DrawnPanel panel;
  panel.text = fmt::format(
      "<clipPath id=\"{}\"><rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/></clipPath>\n"
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"#fbfbf8\"/>\n<g "
      "clip-path=\"url(#{})\">\n",
      clip, box.left, box.top, box.width, box.height, box.left, box.top, box.width, box.height, clip);
  const auto add = [&](const RegionView& view, double dot, const Style& style, std::size_t most_bytes) {
    const DrawnContours drawn = draw_contours(view, frame, DrawAs::polygons, dot, most_bytes);
    panel.gathered += drawn.gathered;
    panel.left_out += drawn.left_out;
    if (drawn.drawn + drawn.gathered > 0) panel.text += draw_filled(drawn, style);
  };
  for (const PictureClass& rows : picture.classes)
    add(rows.regions, 2, {rows.colour.c_str(), 0.9, "#fff", line / 2}, bytes_of_classes / picture.classes.size());
  constexpr std::size_t bytes_of_regions = 650'000;
  if (picture.classes.empty()) {
    add(picture.a, 2, {colour_a, 0.25, colour_a, line / 2}, bytes_of_regions);
    add(picture.b, 2, {colour_b, 0.25, colour_b, line / 2}, bytes_of_regions);
    add(picture.result, 2, {colour_result, 0.75, colour_result_edge, line}, bytes_of_regions);
  }
  panel.text += draw_lines(picture.lines, frame, colour_of_lines, std::max(1.5 * line, 0.5));
  for (const PictureMarks& marks : picture.marks) panel.text += draw_marks(marks, frame);
  panel.text += "</g>\n" + draw_axes(frame) + draw_scale_bar(frame, picture.projection, picture.unit);
  return panel;
}

// Marks the window of the enlarged panel in the main panel, large enough to be visible.
std::string mark_zoom(const Frame& main, const Frame& zoom) {
  const double width = std::max(8.0, zoom.window.width() * main.x_scale),
               height = std::max(8.0, zoom.window.height() * main.y_scale);
  const double x = main.px(zoom.window.x0 / 2 + zoom.window.x1 / 2),
               y = main.py(zoom.window.y0 / 2 + zoom.window.y1 / 2);
  const double left = x - width / 2, top = y - height / 2;
  const bool label_left = left + width + 70 > main.box.left + main.box.width;
  return fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" stroke=\"{}\" "
      "stroke-width=\"2\"/>"
      "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"12\" fill=\"{}\" text-anchor=\"{}\" stroke=\"#fff\" "
      "stroke-width=\"3\" paint-order=\"stroke\">enlarged</text>\n"
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" stroke=\"{}\" "
      "stroke-width=\"2\"/>\n",
      left, top, width, height, colour_zoom, label_left ? left - 5 : left + width + 5, y + 4, colour_zoom,
      label_left ? "end" : "start", zoom.box.left, zoom.box.top, zoom.box.width, zoom.box.height, colour_zoom);
}

std::string draw_note(const DrawnPanel& panel, double page_height) {
  std::string note;
  if (panel.gathered)
    note = counted_in_picture(panel.gathered, "contour", "contours") +
           " below a pixel: the stronger the colour, the more of the place is covered";
  if (panel.left_out)
    note += (note.empty() ? "" : "; ") + counted_in_picture(panel.left_out, "polygon", "polygons") +
            " left out, because the picture would become too large";
  if (note.empty()) return {};
  return fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" font-size=\"12\" fill=\"#555\">{}</text>\n", margin_left,
                     page_height - 10, note);
}

}  // namespace

std::string to_svg(const Picture& picture) {
  std::vector<RegionView> views{picture.a, picture.b, picture.result};
  for (const PictureClass& rows : picture.classes) views.push_back(rows.regions);
  views.push_back({picture.lines.vertices, {}, {}});
  for (const PictureMarks& marks : picture.marks) views.push_back({marks.points, {}, {}});
  const Window window = extent(views).value_or(Window{0, 0, 1, 1});
  const PictureHeader header = draw_header(picture);
  const Panels panels = lay_out(picture, window, header.height);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "font-family=\"Helvetica, Arial, sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      page_width, panels.page_height);
  const DrawnPanel main = draw_panel(picture, panels.main, "main", panels.zoom ? 0 : 1);
  text += header.text + main.text + draw_note(main, panels.page_height);
  if (panels.zoom) text += draw_panel(picture, *panels.zoom, "zoom", 1.2).text + mark_zoom(panels.main, *panels.zoom);
  return text + "</svg>\n";
}

}  // namespace oblast::io
