// Entries of the legend flow like words; see picture_header.h.
#include "io/picture_header.h"

#include <fmt/format.h>

#include <vector>

#include "io/picture_text.h"

namespace oblast::io {

namespace {

constexpr double title_size = 20, legend_size = 13, title_line = 25, legend_line = 21, swatch = 26, between = 26;
constexpr double room = page_width - margin_left - margin_right;

struct Entry {
  std::string swatch;  // attributes of the rectangle
  std::string text;
};

Entry entry_of(const std::string& label, const RegionView& view, std::string swatch_style) {
  const std::string counts = fmt::format(": {}, {}", counted_in_picture(view.contour_count(), "contour", "contours"),
                                         counted_in_picture(view.points.size(), "vertex", "vertices"));
  const std::string name = fitted(readable(label), legend_size, room / 2);
  return {std::move(swatch_style), name + counts};
}

std::vector<Entry> entries_of(const Picture& picture) {
  std::vector<Entry> entries;
  if (!picture.classes.empty()) {
    for (const PictureClass& rows : picture.classes)
      entries.push_back({fmt::format("fill=\"{}\"", rows.colour), readable(rows.label)});
    return entries;
  }
  const auto operand = [](const char* colour) {
    return fmt::format("fill=\"{0}\" fill-opacity=\"0.25\" stroke=\"{0}\"", colour);
  };
  entries.push_back(entry_of(picture.label_a, picture.a, operand(colour_a)));
  if (!picture.b.points.empty()) entries.push_back(entry_of(picture.label_b, picture.b, operand(colour_b)));
  entries.push_back(
      entry_of(picture.label_result, picture.result,
               fmt::format("fill=\"{}\" fill-opacity=\"0.75\" stroke=\"{}\"", colour_result, colour_result_edge)));
  return entries;
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
    header.text += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"18\" height=\"13\" {}/><text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x,
        y - 11, entry.swatch, x + swatch, y, escaped(text));
    x += width + between;
  }
  header.text += "</g>\n";
  header.height = y + 18;
  return header;
}

}  // namespace oblast::io
