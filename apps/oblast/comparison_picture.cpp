// The picture of a comparison: a grid of panels, one for each method.
#include <fmt/format.h>

#include <cmath>

#include "io/picture_contours.h"
#include "io/picture_frame.h"
#include "oblast/comparison.h"
#include "oblast/names.h"

namespace oblast::app {

namespace {

constexpr double panel_width = 300, panel_height = 240, gap = 20, header = 40, caption = 38, verdict_width = 84;
constexpr std::size_t columns = 4;

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '&' ? std::string("&amp;") : c == '<' ? std::string("&lt;") : std::string(1, c);
  return result;
}

std::string text_at(double x, double y, int size, const char* colour, const std::string& text) {
  return fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" font-size=\"{}\" fill=\"{}\">{}</text>\n", x, y, size, colour,
                     escaped(text));
}

std::string duration(double seconds) {
  return seconds < 1e-3 ? fmt::format("{:.3g} us", seconds * 1e6) : fmt::format("{:.3g} ms", seconds * 1e3);
}

/// Breaks a text into lines of at most `width` characters.
std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
  std::vector<std::string> lines{""};
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    if (!lines.back().empty() && lines.back().size() + 1 + end - at > width) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + text.substr(at, end - at);
    at = end + 1;
  }
  return lines;
}

std::string operand(const io::DrawnContours& drawn, const char* colour) {
  return fmt::format(
      "<g fill=\"{0}\" fill-opacity=\"0.4\" fill-rule=\"evenodd\" transform=\"scale(0.1)\">\n{1}{2}</g>\n", colour,
      drawn.polygons, drawn.dots);
}

std::string panel(const Row& row, const io::Frame& frame, const std::string& operands) {
  const io::Box& box = frame.box;
  std::string text = fmt::format(
      "<rect x=\"{:.0f}\" y=\"{:.0f}\" width=\"{:.0f}\" height=\"{:.0f}\" fill=\"#fbfbf8\" stroke=\"#ccc\"/>\n",
      box.left, box.top, box.width, box.height);
  text += text_at(box.left, box.top - 22, 15, "#1a202c", row.method->title);
  if (!row.admitted) {
    text += text_at(box.left, box.top - 6, 12, "#c53030", "does not accept this input");
    double y = box.top + 24;
    for (const std::string& line : wrapped(row.why_not, 44))
      text += text_at(box.left + 12, y, 12, "#555", line), y += 16;
    return text;
  }
  const std::size_t contours = row.result.contour_ends.size();
  text += text_at(box.left, box.top - 6, 12, "#555",
                  fmt::format("{}, {} contour{}, {} vertices", duration(row.seconds), contours,
                              contours == 1 ? "" : "s", row.result.points.size()));
  text += text_at(box.left + box.width - verdict_width, box.top - 22, 12, row.same_bytes ? "#276749" : "#c53030",
                  row.same_bytes ? "same bytes" : "OTHER BYTES");
  const io::DrawnContours result = io::draw_contours(row.result, frame, io::DrawAs::outlines, 1);
  text += operands;
  text += fmt::format(
      "<path d=\"{0}\" fill=\"#1a202c\" fill-opacity=\"0.12\" fill-rule=\"evenodd\" stroke=\"#1a202c\" "
      "stroke-width=\"12\" stroke-linejoin=\"round\" transform=\"scale(0.1)\"/>\n<g fill=\"#1a202c\" "
      "transform=\"scale(0.1)\">{1}</g>\n",
      result.outlines, result.dots);
  return text;
}

}  // namespace

std::string draw(const std::vector<Row>& rows, const OperandPair& pair, Operation operation) {
  const RegionView views[] = {pair.a.regions, pair.b.regions};
  const io::Window window = io::extent(views).value_or(io::Window{0, 0, 1, 1});
  double squeeze = 1;
  if (pair.crs_wkt().rfind("GEOG", 0) == 0)
    squeeze = std::cos((window.y0 / 2 + window.y1 / 2) * 3.14159265358979323846 / 180);
  const std::size_t lines = (rows.size() + columns - 1) / columns;
  const double width = gap + columns * (panel_width + gap);
  const double height = header + static_cast<double>(lines) * (panel_height + caption + gap) + gap;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "font-family=\"sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      width, height);
  svg += text_at(gap, 28, 18, "#1a202c",
                 fmt::format("{} of A (blue, {} vertices) and B (orange, {} vertices) by every method", name(operation),
                             pair.a.regions.points.size(), pair.b.regions.points.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t row = i / columns, column = i % columns;
    const io::Box box{gap + static_cast<double>(column) * (panel_width + gap),
                      header + caption + static_cast<double>(row) * (panel_height + caption + gap), panel_width,
                      panel_height};
    const io::Frame frame = io::fit(window, squeeze, box);
    std::string operands;
    if (rows[i].admitted) {
      operands = operand(io::draw_contours(pair.a.regions, frame, io::DrawAs::polygons, 1), "#2b6cb0");
      operands += operand(io::draw_contours(pair.b.regions, frame, io::DrawAs::polygons, 1), "#dd6b20");
    }
    svg += panel(rows[i], frame, operands);
  }
  return svg + "</svg>\n";
}

}  // namespace oblast::app
