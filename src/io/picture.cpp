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
#include "io/picture.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <vector>

#include "io/layer.h"
#include "io/picture_axes.h"
#include "io/picture_contours.h"
#include "io/picture_frame.h"
#include "io/staged_output.h"
#include "io/write_text.h"

namespace oblast::io {

namespace {

namespace fs = std::filesystem;

constexpr double page_width = 1200, margin_left = 60, margin_right = 20, header = 74, footer = 30, gap = 34;
constexpr double tallest_panel = 820;
constexpr std::size_t bytes_of_classes = 1'400'000;  // in one panel
constexpr const char* colour_a = "#2b6cb0";
constexpr const char* colour_b = "#dd6b20";
constexpr const char* colour_result = "#1a202c";
constexpr const char* colour_zoom = "#c53030";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (static_cast<unsigned char>(c) < 0x20)
      result += ' ';
    else
      result += c;
  }
  return result;
}

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
  return digits;
}

struct Panels {
  Frame main;
  std::optional<Frame> zoom;
  double page_height = 0;
};

// The panels for data of this extent. The enlarged panel is below wide data and beside tall data.
Panels lay_out(const Picture& picture, const Window& window) {
  double squeeze = 1;
  if (picture.projection == MapProjection::longitude_latitude) {
    const double latitude = std::clamp(window.y0 / 2 + window.y1 / 2, -85.0, 85.0);
    squeeze = std::cos(latitude * 3.14159265358979323846 / 180);
  }
  const double full = page_width - margin_left - margin_right;
  const double aspect = std::clamp(window.height() > 0 ? window.width() * squeeze / window.height() : 1e3, 0.2, 6.0);
  const Window padded{window.x0 - window.width() * 0.02, window.y0 - window.height() * 0.02,
                      window.x1 + window.width() * 0.02, window.y1 + window.height() * 0.02};
  RegionView dense = picture.result.points.empty() ? picture.a : picture.result;
  for (const PictureClass& rows : picture.classes)
    if (rows.regions.points.size() > dense.points.size()) dense = rows.regions;

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
  const std::optional<Window> enlarged = densest_window(dense, panels.main, zoom_box);
  if (!enlarged) return panels;
  if (!wide) panels.main = fit(padded, squeeze, {margin_left, header, half, beside.height});
  panels.zoom = fit(*enlarged, squeeze, zoom_box);
  panels.page_height = zoom_box.top + zoom_box.height + footer;
  return panels;
}

struct Style {
  const char* colour;
  double opacity;
};

std::string draw_operand(const DrawnContours& drawn, const Style& style) {
  return fmt::format(
      "<g fill=\"{0}\" fill-opacity=\"{1}\" fill-rule=\"evenodd\" transform=\"scale(0.1)\">\n{2}</g>\n"
      "<path d=\"{3}\" fill=\"{0}\" fill-opacity=\"{1}\" transform=\"scale(0.1)\"/>\n",
      style.colour, style.opacity, drawn.polygons, drawn.dots);
}

std::string draw_result(const DrawnContours& drawn, double stroke) {
  return fmt::format(
      "<path d=\"{0}\" fill=\"none\" stroke=\"{1}\" stroke-width=\"{2:.0f}\" stroke-linejoin=\"round\" "
      "transform=\"scale(0.1)\"/>\n"
      "<path d=\"{3}\" fill=\"{1}\" fill-opacity=\"0.8\" transform=\"scale(0.1)\"/>\n",
      drawn.outlines, colour_result, stroke * 10, drawn.dots);
}

struct DrawnPanel {
  std::string text;
  std::uint64_t gathered = 0;
  std::uint64_t left_out = 0;
};

DrawnPanel draw_panel(const Picture& picture, const Frame& frame, const std::string& clip, double stroke) {
  const Box& box = frame.box;
  DrawnPanel panel;
  panel.text = fmt::format(
      "<clipPath id=\"{}\"><rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/></clipPath>\n"
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"#fbfbf8\"/>\n<g "
      "clip-path=\"url(#{})\">\n",
      clip, box.left, box.top, box.width, box.height, box.left, box.top, box.width, box.height, clip);
  const auto count = [&](const DrawnContours& drawn) {
    panel.gathered += drawn.gathered;
    panel.left_out += drawn.left_out;
  };
  const double opacity = picture.b.points.empty() ? 0.35 : 0.45;
  for (const PictureClass& rows : picture.classes) {
    const DrawnContours drawn =
        draw_contours(rows.regions, frame, DrawAs::polygons, 2, bytes_of_classes / picture.classes.size());
    count(drawn);
    panel.text += draw_operand(drawn, {rows.colour.c_str(), 0.9});
  }
  const DrawnContours result = draw_contours(picture.result, frame, DrawAs::outlines, 1);
  count(result);
  if (picture.classes.empty()) {
    const DrawnContours a = draw_contours(picture.a, frame, DrawAs::polygons, 2);
    const DrawnContours b = draw_contours(picture.b, frame, DrawAs::polygons, 2);
    for (const DrawnContours* drawn : {&a, &b}) count(*drawn);
    panel.text += draw_operand(a, {colour_a, opacity});
    if (!picture.b.points.empty()) panel.text += draw_operand(b, {colour_b, opacity});
  }
  panel.text += draw_result(result, stroke) + "</g>\n" + draw_axes(frame) + draw_scale_bar(frame, picture.projection);
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

std::string legend_entry(double& x, const std::string& swatch, const std::string& label, const RegionView& view) {
  const std::string text =
      fmt::format("{}: {} contours, {} vertices", label, grouped(view.contour_count()), grouped(view.points.size()));
  const std::string entry =
      fmt::format("<rect x=\"{:.0f}\" y=\"46\" width=\"18\" height=\"13\" {}/><text x=\"{:.0f}\" y=\"57\">{}</text>\n",
                  x, swatch, x + 25, escaped(text));
  x += 60 + 7.0 * static_cast<double>(text.size());
  return entry;
}

std::string draw_classes_legend(const std::vector<PictureClass>& classes) {
  double x = margin_left;
  std::string text = "<g font-size=\"13\">";
  for (const PictureClass& rows : classes) {
    text += fmt::format(
        "<rect x=\"{:.0f}\" y=\"46\" width=\"18\" height=\"13\" fill=\"{}\"/><text x=\"{:.0f}\" y=\"57\">{}</text>\n",
        x, rows.colour, x + 24, escaped(rows.label));
    x += 44 + 7.0 * static_cast<double>(rows.label.size());
  }
  return text + "</g>\n";
}

std::string draw_legend(const Picture& picture) {
  if (!picture.classes.empty()) return draw_classes_legend(picture.classes);
  double x = margin_left;
  std::string text = "<g font-size=\"13\">";
  text += legend_entry(x, fmt::format("fill=\"{}\" fill-opacity=\"0.5\"", colour_a), picture.label_a, picture.a);
  if (!picture.b.points.empty()) {
    text += legend_entry(x, fmt::format("fill=\"{}\" fill-opacity=\"0.5\"", colour_b), picture.label_b, picture.b);
  }
  text += legend_entry(x, fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"", colour_result),
                       picture.label_result, picture.result);
  return text + "</g>\n";
}

std::string draw_note(const DrawnPanel& panel) {
  std::string note;
  if (panel.gathered) note += grouped(panel.gathered) + " contours below a pixel are shown as dots";
  if (panel.left_out) note += (note.empty() ? "" : "; ") + grouped(panel.left_out) + " polygons were too many to draw";
  return fmt::format("<text x=\"{:.0f}\" y=\"28\" font-size=\"12\" fill=\"#777\" text-anchor=\"end\">{}</text>\n",
                     page_width - margin_right, note);
}

}  // namespace

std::string to_svg(const Picture& picture) {
  std::vector<RegionView> views{picture.a, picture.b, picture.result};
  for (const PictureClass& rows : picture.classes) views.push_back(rows.regions);
  const Window window = extent(views).value_or(Window{0, 0, 1, 1});
  const Panels panels = lay_out(picture, window);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "font-family=\"Helvetica, Arial, sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      page_width, panels.page_height);
  text += fmt::format("<text x=\"{:.0f}\" y=\"30\" font-size=\"20\" font-weight=\"bold\">{}</text>\n", margin_left,
                      escaped(picture.title));
  text += draw_legend(picture);
  const DrawnPanel main = draw_panel(picture, panels.main, "main", 1);
  text += main.text + draw_note(main);
  if (panels.zoom) text += draw_panel(picture, *panels.zoom, "zoom", 1.4).text + mark_zoom(panels.main, *panels.zoom);
  return text + "</svg>\n";
}

void check_picture_writable(const std::string& path, Existing existing) {
  std::error_code error;
  const fs::path parent = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : fs::path(".");
  if (!fs::is_directory(parent, error))
    throw IoError("cannot write " + path + ": there is no folder " + parent.string() + "; create it first");
  if (fs::is_directory(path, error)) throw IoError("cannot write " + path + ": it is a folder");
  if (existing == Existing::refuse && fs::exists(fs::symlink_status(path, error))) {
    throw IoError(path + " exists already (--overwrite replaces it)");
  }
  if (::access(parent.c_str(), W_OK | X_OK) != 0)
    throw IoError("cannot write into " + parent.string() + ": " + std::strerror(errno));
}

void write_svg(const std::string& path, const Picture& picture, Existing existing) {
  check_picture_writable(path, existing);
  StagedOutput stage(path, {});
  write_text(stage.path(), to_svg(picture), path);
  stage.commit();
}

}  // namespace oblast::io
