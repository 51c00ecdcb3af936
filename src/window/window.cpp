#include "window/window.h"

#include <algorithm>

#include "exact/orientation.h"
#include "noding/simple_ring.h"

namespace oblast::internal::window {

using exact::orientation;

std::span<const Point> without_closing_point(std::span<const Point> contour) {
  while (contour.size() > 1 && contour.back() == contour.front()) contour = contour.first(contour.size() - 1);
  return contour;
}

std::optional<Window> Window::of(std::span<const Point> contour, std::pmr::memory_resource* memory) {
  contour = without_closing_point(contour);
  if (contour.size() < 3 || contour.size() > most_sides) return {};
  const int turn = convex_turn(contour);
  if (turn == 0) return {};
  Window window(memory);
  std::pmr::vector<Point>& corners = window.corners_;
  corners.reserve(contour.size());
  const auto smallest = std::min_element(contour.begin(), contour.end(), lexicographically_less);
  const auto add = [&](const Point& p) { corners.push_back({p.x + 0.0, p.y + 0.0}); };
  if (turn > 0) {
    std::for_each(smallest, contour.end(), add);
    std::for_each(contour.begin(), smallest, add);
  } else {
    std::for_each(std::make_reverse_iterator(smallest + 1), contour.rend(), add);
    std::for_each(contour.rbegin(), std::make_reverse_iterator(smallest + 1), add);
  }
  const auto largest = std::max_element(corners.begin(), corners.end(), lexicographically_less);
  window.largest_ = static_cast<std::uint32_t>(largest - corners.begin());
  window.box_ = Box::of(corners.front(), *largest);
  window.sides_.reserve(corners.size());
  for (std::uint32_t i = 0; i < window.size(); ++i) {
    window.sides_.push_back(Box::of(window.corner(i), window.corner_after(i)));
    window.box_.y0 = std::min(window.box_.y0, corners[i].y);
    window.box_.y1 = std::max(window.box_.y1, corners[i].y);
  }
  return window;
}

bool Window::contains(const Point& p) const {
  for (std::uint32_t i = 0; i < size(); ++i)
    if (orientation(corner(i), corner_after(i), p) <= 0) return false;
  return true;
}

}  // namespace oblast::internal::window
