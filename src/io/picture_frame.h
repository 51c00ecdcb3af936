// The geometry of a picture: windows of the plane, and the panels that show them.
#pragma once

#include <oblast/region_set.h>

#include <optional>
#include <span>

namespace oblast::io {

/// A rectangle of the plane, in coordinates of the data.
struct Window {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  double width() const { return x1 - x0; }
  double height() const { return y1 - y0; }
};

/// A rectangle of the picture, in pixels; y grows downwards.
struct Box {
  double left = 0, top = 0, width = 0, height = 0;
};

/// A panel: a window drawn into a box, filling it.
struct Frame {
  Window window;
  Box box;
  double x_scale = 1;  ///< pixels per unit of x
  double y_scale = 1;  ///< pixels per unit of y

  double px(double x) const { return box.left + (x - window.x0) * x_scale; }
  double py(double y) const { return box.top + (window.y1 - y) * y_scale; }
};

/// The smallest window that contains all points of all views; nothing if there are no points.
std::optional<Window> extent(std::span<const RegionView> views);

/// A frame that shows `window` in the box as large as possible, and more of the plane along the other axis. `squeeze`
/// is the drawn length of a unit of x, in units of y (1, or the cosine of the latitude).
Frame fit(const Window& window, double squeeze, const Box& box);

/// A window to be enlarged: where `places` are densest, at a scale at which the edges of `view` are visible. Nothing if
/// they are visible in `main`. `box` is the panel that the window fills.
std::optional<Window> densest_window(const RegionView& view, std::span<const Point> places, const Frame& main,
                                     const Box& box);

}  // namespace oblast::io
