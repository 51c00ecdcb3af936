// Round numbers along the sides of a panel.
#include "io/picture_axes.h"

#include <fmt/format.h>

#include <cmath>

#include "io/picture_text.h"

namespace oblast::io {

namespace {

constexpr double km_per_degree = 111.195;  // of latitude, on a sphere of 6371 km

// The largest of 1, 2 or 5 times a power of ten that is at most `length`.
double round_length(double length) {
  const double power = std::pow(10, std::floor(std::log10(length)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= length) return factor * power;
  }
  return power;
}

// With enough digits to distinguish neighbouring ticks.
std::string number(double value, double step) {
  if (std::fabs(value) < step / 2) return "0";
  if (step < 1e-9 || std::fabs(value) >= 1e9) return fmt::format("{:.12g}", value);
  const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  return fmt::format("{:.{}f}", value, digits);
}

}  // namespace

std::string draw_axes(const Frame& frame) {
  const Box& box = frame.box;
  const double bottom = box.top + box.height;
  std::string text = fmt::format(
      "<g stroke=\"#999\"><rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\"/>", box.left,
      box.top, box.width, box.height);
  std::string labels = "<g font-size=\"11\" fill=\"#555\">";
  const double x_step = round_length(180 / frame.x_scale), y_step = round_length(110 / frame.y_scale);
  for (double k = std::ceil(frame.window.x0 / x_step); k * x_step <= frame.window.x1; ++k) {
    const double x = frame.px(k * x_step);
    text += fmt::format("<path d=\"M{:.1f} {:.1f}v5\"/>", x, bottom);
    labels += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>", x, bottom + 17,
                          number(k * x_step, x_step));
    if (k + 1 == k) break;  // the window is so far from the origin that doubles cannot distinguish its ticks
  }
  for (double k = std::ceil(frame.window.y0 / y_step); k * y_step <= frame.window.y1; ++k) {
    const double y = frame.py(k * y_step);
    text += fmt::format("<path d=\"M{:.1f} {:.1f}h-5\"/>", box.left, y);
    labels += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", box.left - 8, y + 4,
                          number(k * y_step, y_step));
    if (k + 1 == k) break;
  }
  return text + "</g>\n" + labels + "</g>\n";
}

std::string draw_scale_bar(const Frame& frame, MapProjection projection, const std::string& unit) {
  const bool globe = projection == MapProjection::longitude_latitude;
  const bool metric = globe || unit == "m";
  const double pixels_of_a_unit = globe ? frame.y_scale / km_per_degree / 1000 : frame.y_scale;
  const double length = round_length(160 / pixels_of_a_unit);
  const double pixels = length * pixels_of_a_unit;
  const bool kilometres = metric && length >= 1000;
  const std::string name = fmt::format("{:g} {}", kilometres ? length / 1000 : length,
                                       kilometres ? "km"
                                       : metric   ? "m"
                                                  : escaped(unit == "units" && length == 1 ? "unit" : unit));
  const double right = frame.box.left + frame.box.width - 14, y = frame.box.top + frame.box.height - 14;
  return fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"28\" rx=\"3\" fill=\"#fff\" fill-opacity=\"0.85\"/>"
      "<path d=\"M{:.1f} {:.1f}v5h{:.1f}v-5\" fill=\"none\" stroke=\"#333\" stroke-width=\"1.5\"/>"
      "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"12\" text-anchor=\"middle\">{}</text>\n",
      right - pixels - 8, y - 20, pixels + 16, right - pixels, y - 3, pixels, right - pixels / 2, y - 7, name);
}

}  // namespace oblast::io
