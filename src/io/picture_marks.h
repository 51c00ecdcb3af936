// Lines and points in pictures. They lie over everything else, so that none is hidden.
#pragma once

#include <string>

#include "io/picture.h"
#include "io/picture_frame.h"

namespace oblast::io {

/// The part of the lines that lies in the frame, `width` pixels wide. Vertices are snapped to a tenth of a pixel, or
/// coarser where the text would be larger than about half a megabyte.
std::string draw_lines(const PictureLines& lines, const Frame& frame, const char* colour, double width);

/// A dot for each point in the frame, white around it; points that share a dot are drawn once.
std::string draw_marks(const PictureMarks& marks, const Frame& frame);

}  // namespace oblast::io
