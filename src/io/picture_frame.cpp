// Extents, scales and the choice of the enlarged place.
#include "io/picture_frame.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace oblast::io {

namespace {

constexpr double visible_edge = 1.5;  // pixels: a median edge this long needs no enlarging
constexpr double enlarged_edge = 14;  // pixels a median edge gets in the enlarged panel
constexpr double largest_zoom = 1e6;
constexpr std::size_t sample_size = 20000;

// The median length in pixels of the view's edges in the frame, estimated from a sample.
double median_edge(const RegionView& view, const Frame& frame) {
  std::vector<double> lengths;
  const std::size_t stride = view.points.size() / sample_size + 1;
  std::size_t next = 0;
  for (std::size_t c = 0; c < view.contour_count(); ++c) {
    for (next = std::max<std::size_t>(next, view.contour_begin(c)); next + 1 < view.contour_end(c); next += stride) {
      const Point p = view.points[next], q = view.points[next + 1];
      lengths.push_back(std::hypot((p.x - q.x) * frame.x_scale, (p.y - q.y) * frame.y_scale));
    }
  }
  if (lengths.empty()) return visible_edge;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

// The middle of the 2 x 2 block of cells with the most places; of several, the one with the smallest column and row.
Point densest_place(std::span<const Point> places, const Window& window, double cell_width, double cell_height) {
  const auto key = [](std::int64_t column, std::int64_t row) { return (column << 32) | row; };
  std::unordered_map<std::int64_t, std::uint32_t> counts;
  for (const Point& p : places) {
    ++counts[key(static_cast<std::int64_t>((p.x - window.x0) / cell_width),
                 static_cast<std::int64_t>((p.y - window.y0) / cell_height))];
  }
  std::int64_t best = 0;
  std::uint64_t most = 0;
  for (const auto& [cell, count] : counts) {
    std::uint64_t sum = count;
    for (const std::int64_t other : {cell + 1, cell + key(1, 0), cell + key(1, 1)}) {
      if (const auto found = counts.find(other); found != counts.end()) sum += found->second;
    }
    if (sum > most || (sum == most && cell < best)) {
      most = sum;
      best = cell;
    }
  }
  return {window.x0 + (static_cast<double>(best >> 32) + 1) * cell_width,
          window.y0 + (static_cast<double>(best & 0xffffffff) + 1) * cell_height};
}

}  // namespace

std::optional<Window> extent(std::span<const RegionView> views) {
  std::optional<Window> window;
  for (const RegionView& view : views) {
    for (const Point& p : view.points) {
      if (!window) window = Window{p.x, p.y, p.x, p.y};
      window->x0 = std::min(window->x0, p.x);
      window->y0 = std::min(window->y0, p.y);
      window->x1 = std::max(window->x1, p.x);
      window->y1 = std::max(window->y1, p.y);
    }
  }
  return window;
}

Frame fit(const Window& window, double squeeze, const Box& box) {
  Frame frame{window, box, 1, 1};
  const double width = window.width() * squeeze, height = window.height();
  double scale = std::min(width > 0 ? box.width / width : HUGE_VAL, height > 0 ? box.height / height : HUGE_VAL);
  if (!std::isfinite(scale)) scale = 1;  // a single point
  frame.x_scale = scale * squeeze;
  frame.y_scale = scale;
  const double x_middle = window.x0 / 2 + window.x1 / 2, y_middle = window.y0 / 2 + window.y1 / 2;
  frame.window = {x_middle - box.width / 2 / frame.x_scale, y_middle - box.height / 2 / frame.y_scale,
                  x_middle + box.width / 2 / frame.x_scale, y_middle + box.height / 2 / frame.y_scale};
  return frame;
}

std::optional<Window> densest_window(const RegionView& view, std::span<const Point> places, const Frame& main,
                                     const Box& box) {
  const double edge = median_edge(view, main);
  if (edge >= visible_edge || places.empty()) return std::nullopt;
  const double zoom = std::min(enlarged_edge / std::max(edge, 1e-12), largest_zoom);
  const double width = box.width / (main.x_scale * zoom), height = box.height / (main.y_scale * zoom);
  if (!(width > 0) || !(height > 0) || !std::isfinite(zoom)) return std::nullopt;
  const Point middle = densest_place(places, main.window, width / 2, height / 2);
  return Window{middle.x - width / 2, middle.y - height / 2, middle.x + width / 2, middle.y + height / 2};
}

}  // namespace oblast::io
