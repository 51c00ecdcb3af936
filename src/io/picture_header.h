// The head of a picture: the title, and the legend below it, on as many lines as they need.
#pragma once

#include <string>

#include "io/picture.h"

namespace oblast::io {

inline constexpr double page_width = 1200, margin_left = 60, margin_right = 20;

inline constexpr const char* colour_a = "#2b7bba";
inline constexpr const char* colour_b = "#e08a1e";
inline constexpr const char* colour_result = "#0f9d76";
inline constexpr const char* colour_result_edge = "#064c39";

struct PictureHeader {
  std::string text;   ///< SVG elements
  double height = 0;  ///< pixels from the upper side of the page to the panels
};

PictureHeader draw_header(const Picture& picture);

}  // namespace oblast::io
