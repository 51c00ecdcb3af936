// Entries of the legend flow like words; see picture_header.h.
#include "io/picture_header.h"

#include <fmt/format.h>

#include <vector>

#include "io/picture_text.h"

namespace oblast::io {

namespace {

constexpr double title_size = 20, legend_size = 13, title_line = 25, legend_line = 21, swatch = 26, between = 26;
constexpr double room = page_width - margin_left - margin_right;

enum class Shape { area, line, dot };

struct Entry {
  std::string swatch;  // attributes of the shape
  std::string text;
  Shape shape = Shape::area;
};

Entry entry_of(const std::string& label, const RegionView& view, std::string swatch_style) {
  const std::string counts = fmt::format(": {}, {}", counted_in_picture(view.contour_count(), "contour", "contours"),
                                         counted_in_picture(view.points.size(), "vertex", "vertices"));
  const std::string name = fitted(readable(label), legend_size, room / 2);
  return {std::move(swatch_style), name + counts};
}

Entry entry_of_lines(const Picture& picture) {
  const std::string counts = fmt::format(": {}, {}", counted_in_picture(picture.lines.ends.size(), "line", "lines"),
                                         counted_in_picture(picture.lines.vertices.size(), "vertex", "vertices"));
  return {fmt::format("stroke=\"{}\" stroke-width=\"2\"", colour_of_lines),
          fitted(readable(picture.label_a), legend_size, room / 2) + counts, Shape::line};
}

void add_regions(const Picture& picture, std::vector<Entry>& entries) {
  if (!picture.classes.empty()) {
    for (const PictureClass& rows : picture.classes)
      entries.push_back({fmt::format("fill=\"{}\"", rows.colour), readable(rows.label)});
    return;
  }
  const auto operand = [](const char* colour) {
    return fmt::format("fill=\"{0}\" fill-opacity=\"0.25\" stroke=\"{0}\"", colour);
  };
  const bool only_others = picture.a.points.empty() && (!picture.lines.ends.empty() || !picture.marks.empty());
  if (!only_others) entries.push_back(entry_of(picture.label_a, picture.a, operand(colour_a)));
  if (!picture.b.points.empty()) entries.push_back(entry_of(picture.label_b, picture.b, operand(colour_b)));
  if (picture.label_result.empty()) return;
  entries.push_back(
      entry_of(picture.label_result, picture.result,
               fmt::format("fill=\"{}\" fill-opacity=\"0.75\" stroke=\"{}\"", colour_result, colour_result_edge)));
}

std::vector<Entry> entries_of(const Picture& picture) {
  std::vector<Entry> entries;
  add_regions(picture, entries);
  if (!picture.lines.ends.empty()) entries.push_back(entry_of_lines(picture));
  for (const PictureMarks& marks : picture.marks)
    entries.push_back({fmt::format("fill=\"{}\"", marks.colour), readable(marks.label), Shape::dot});
  return entries;
}

std::string draw_swatch(const Entry& entry, double x, double y) {
  if (entry.shape == Shape::dot)
    return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" {}/>", x + 9, y - 4.5, entry.swatch);
  if (entry.shape == Shape::line)
    return fmt::format("<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{2:.1f}\" y2=\"{1:.1f}\" {3}/>", x, y - 4.5, x + 18,
                       entry.swatch);
  return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"18\" height=\"13\" {}/>", x, y - 11, entry.swatch);
}

}  // namespace

PictureHeader draw_header(const Picture& picture) {
  PictureHeader header;
  double y = 30;
  for (const std::string& line : wrapped(readable(picture.title), title_size, room, 2)) {
    header.text += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" font-size=\"{:.0f}\" font-weight=\"bold\">{}</text>\n",
                               margin_left, y, title_size, escaped(line));
    y += title_line;
  }
  double x = margin_left;
  header.text += fmt::format("<g font-size=\"{:.0f}\">", legend_size);
  for (const Entry& entry : entries_of(picture)) {
    const std::string text = fitted(entry.text, legend_size, room - swatch);
    const double width = swatch + text_width(text, legend_size);
    if (x > margin_left && x + width > margin_left + room) {
      x = margin_left;
      y += legend_line;
    }
    header.text += draw_swatch(entry, x, y) +
                   fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x + swatch, y, escaped(text));
    x += width + between;
  }
  header.text += "</g>\n";
  header.height = y + 18;
  return header;
}

}  // namespace oblast::io
