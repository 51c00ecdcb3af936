// Paths are in tenths of a pixel, as those of contours; see picture_marks.h.
#include "io/picture_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

namespace oblast::io {

namespace {

constexpr std::size_t most_bytes = 500'000;
constexpr double clip_margin = 5;                   // pixels beyond the panel
constexpr double steps[] = {0.1, 0.5, 1, 2, 4, 8};  // of the lattice, in pixels; the last one is taken anyway

using Snapped = std::pair<std::int64_t, std::int64_t>;  // tenths of a pixel

Snapped snapped(const Point& p, double step) {
  const auto tenths = [&](double value) { return static_cast<std::int64_t>(std::round(value / step) * step * 10); };
  return {tenths(p.x), tenths(p.y)};
}

// The part of an edge within the panel (Liang and Barsky). Renderers cannot draw coordinates far beyond it.
std::optional<std::pair<Point, Point>> clipped(const Point& p, const Point& q, const Box& box) {
  double from = 0, to = 1;
  const auto cut = [&](double start, double step, double least, double most) {
    if (step == 0) return least <= start && start <= most;
    const double at_least = (least - start) / step, at_most = (most - start) / step;
    from = std::max(from, std::min(at_least, at_most));
    to = std::min(to, std::max(at_least, at_most));
    return from <= to;
  };
  const Point step{q.x - p.x, q.y - p.y};
  if (!cut(p.x, step.x, box.left - clip_margin, box.left + box.width + clip_margin)) return std::nullopt;
  if (!cut(p.y, step.y, box.top - clip_margin, box.top + box.height + clip_margin)) return std::nullopt;
  const auto at = [&](double t) { return t == 0 ? p : t == 1 ? q : Point{p.x + t * step.x, p.y + t * step.y}; };
  return std::pair(at(from), at(to));
}

// The lines as the data of a path. Edges that are snapped to the same two places are drawn once: dense lines on a
// coarse lattice are many copies of few edges. Nothing if the path becomes too large, unless `keep_going`.
std::optional<std::string> path_of(const PictureLines& lines, const Frame& frame, double step, bool keep_going) {
  std::string path;
  std::set<std::pair<Snapped, Snapped>> drawn;
  std::uint32_t begin = 0;
  for (const std::uint32_t end : lines.ends) {
    std::optional<Snapped> pen;  // where the path has arrived
    for (std::uint32_t v = begin; v + 1 < end; ++v) {
      const Point &a = lines.vertices[v], &b = lines.vertices[v + 1];
      const auto edge = clipped({frame.px(a.x), frame.py(a.y)}, {frame.px(b.x), frame.py(b.y)}, frame.box);
      if (!edge) continue;
      const Snapped from = snapped(edge->first, step), to = snapped(edge->second, step);
      if (!drawn.insert(std::minmax(from, to)).second) continue;
      if (pen != from) path += fmt::format("M{} {}", from.first, from.second);
      if (pen != from || to != from) path += fmt::format("L{} {}", to.first, to.second);
      pen = to;
    }
    begin = end;
    if (path.size() > most_bytes && !keep_going) return std::nullopt;
  }
  return path;
}

// One dot for all points that are snapped to one place. Nothing if these are too many, unless `keep_going`.
std::optional<std::set<Snapped>> dots_of(const std::vector<Point>& points, const Frame& frame, double step,
                                         bool keep_going) {
  constexpr std::size_t bytes_of_dot = 24;
  const Box& box = frame.box;
  std::set<Snapped> dots;
  for (const Point& p : points) {
    const Point at{frame.px(p.x), frame.py(p.y)};
    if (at.x < box.left - clip_margin || at.x > box.left + box.width + clip_margin) continue;
    if (at.y < box.top - clip_margin || at.y > box.top + box.height + clip_margin) continue;
    dots.insert(snapped(at, step));
    if (dots.size() * bytes_of_dot > most_bytes && !keep_going) return std::nullopt;
  }
  return dots;
}

}  // namespace

std::string draw_lines(const PictureLines& lines, const Frame& frame, const char* colour, double width) {
  std::optional<std::string> path;
  for (const double step : steps)
    if (!path) path = path_of(lines, frame, step, step == std::end(steps)[-1]);
  if (path->empty()) return {};
  return fmt::format(
      "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.0f}\" stroke-linejoin=\"round\" "
      "stroke-linecap=\"round\" transform=\"scale(0.1)\"/>\n",
      *path, colour, width * 10);
}

std::string draw_marks(const PictureMarks& marks, const Frame& frame) {
  std::optional<std::set<Snapped>> dots;
  for (const double step : steps)
    if (!dots) dots = dots_of(marks.points, frame, step, step == std::end(steps)[-1]);
  if (dots->empty()) return {};
  std::string path;
  for (const auto& [x, y] : *dots) path += fmt::format("M{} {}h0", x, y);  // round caps make it a dot
  std::string text = "<g stroke-linecap=\"round\" fill=\"none\" transform=\"scale(0.1)\">\n";
  const double size = marks.size * 10;
  for (const auto& [colour, width] : {std::pair{std::string("#fff"), size + 20}, {marks.colour, size}})
    text += fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"{:.0f}\"/>\n", path, colour, width);
  return text + "</g>\n";
}

}  // namespace oblast::io
