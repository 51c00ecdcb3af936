// A convex window made ready to be met by edges.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <memory_resource>
#include <optional>
#include <span>
#include <vector>

#include "base/tuning.h"
#include "plane/box.h"

namespace oblast::internal::window {

/// Corners counter-clockwise from the lexicographically smallest one, straight ones included. Sides 0 to
/// largest - 1 are the lower chain, which runs to the right; the others are the upper one, which runs back.
class Window {
 public:
  /// More sides are not worth the search for those that an edge comes near.
  static constexpr std::size_t most_sides = tuning::most_window_sides;

  /// Nothing when the contour is not convex, has repeated neighbours, or too many sides. Cost: linear, and for
  /// most contours that are not convex a few vertices.
  static std::optional<Window> of(std::span<const Point> contour,
                                  std::pmr::memory_resource* memory = std::pmr::get_default_resource());

  std::uint32_t size() const { return static_cast<std::uint32_t>(corners_.size()); }
  const Point& corner(std::uint32_t i) const { return corners_[i]; }
  const Point& corner_after(std::uint32_t i) const { return corners_[i + 1 == size() ? 0 : i + 1]; }
  const Box& box() const { return box_; }

  /// Exactly: inside, not on the boundary.
  bool contains(const Point& p) const;

  /// Calls visit(side) for every side whose box meets `box`; stops and returns false when visit does.
  template <class Visit>
  bool each_side_near(const Box& box, const Visit& visit) const {
    const auto try_sides = [&](std::uint32_t first, std::uint32_t last) {
      for (std::uint32_t i = first; i < last; ++i)
        if (box.meets(sides_[i]) && !visit(i)) return false;
      return true;
    };
    if (size() <= few_sides) return try_sides(0, size());
    // In x the lower chain ascends and the upper one descends.
    const auto first_where = [](std::uint32_t first, std::uint32_t last, const auto& holds) {
      while (first < last) {
        const std::uint32_t middle = first + (last - first) / 2;
        holds(middle) ? last = middle : first = middle + 1;
      }
      return first;
    };
    const auto lower = first_where(0, largest_, [&](std::uint32_t i) { return corner_after(i).x >= box.x0; });
    const auto upper = first_where(largest_, size(), [&](std::uint32_t i) { return corner_after(i).x <= box.x1; });
    for (std::uint32_t i = lower; i < largest_ && corner(i).x <= box.x1; ++i)
      if (!try_sides(i, i + 1)) return false;
    for (std::uint32_t i = upper; i < size() && corner(i).x >= box.x0; ++i)
      if (!try_sides(i, i + 1)) return false;
    return true;
  }

 private:
  static constexpr std::uint32_t few_sides = tuning::few_window_sides;

  explicit Window(std::pmr::memory_resource* memory) : corners_(memory), sides_(memory) {}

  std::pmr::vector<Point> corners_;
  std::pmr::vector<Box> sides_;  ///< boxes of the sides
  std::uint32_t largest_ = 0;
  Box box_{};
};

/// The contour without points at its end that repeat its first one.
std::span<const Point> without_closing_point(std::span<const Point> contour);

}  // namespace oblast::internal::window
