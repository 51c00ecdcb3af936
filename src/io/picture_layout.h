// The layout of a picture: title, legend, the main panel, and an enlarged panel if it is needed.
//
//     title
//     [A] fires: 20,634 contours   [ ] union: 12,841 contours      legend
//     +--------------------------------------------+
//     | main panel                     [zoom]      |               flat data: the enlarged panel below;
//     +--------------------------------------------+               else beside
//     +--------------------------------------------+
//     | the window marked above, enlarged          |
//     +--------------------------------------------+
//     note on what is not drawn as it is
#pragma once

#include <optional>

#include "io/picture.h"
#include "io/picture_frame.h"

namespace oblast::io {

struct Panels {
  Frame main;
  std::optional<Frame> zoom;
  double page_height = 0;
};

/// The panels for data of this extent. `header` is the height of title and legend.
Panels lay_out(const Picture& picture, const Window& window, double header);

}  // namespace oblast::io
