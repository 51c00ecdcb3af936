// SVG pictures of operands and results.
#pragma once

#include <oblast/region_set.h>

#include <string>
#include <vector>

#include "io/write.h"

namespace oblast::io {

/// How coordinates are drawn: as they are, or as degrees scaled by the cosine of the mean latitude.
enum class MapProjection { plane, longitude_latitude };

/// Rows of one colour.
struct PictureClass {
  RegionSet regions;
  std::string colour;  ///< as in SVG: "#0072b2"
  std::string label;   ///< for the legend
};

struct Picture {
  RegionView a;       ///< first operand, translucent
  RegionView b;       ///< second operand, another translucent colour; may be empty
  RegionView result;  ///< outlined
  std::string title;
  std::string label_a = "A";
  std::string label_b = "B";
  std::string label_result = "result";
  MapProjection projection = MapProjection::plane;
  /// Rows by colour, in the order of the legend. If there are any, they are filled, and drawn in place of a and b.
  std::vector<PictureClass> classes = {};
};

/// Writes an SVG with a legend, axes and a scale bar. If details are smaller than a pixel, a second panel shows the
/// densest place enlarged. The file has at most about 4 MB for any input: vertices are snapped to a tenth of a pixel or
/// coarser, and contours smaller than a pixel are shown as dots. Throws IoError; then an older file at `path` is
/// unchanged.
void write_svg(const std::string& path, const Picture& picture, Existing existing = Existing::refuse);

/// Throws IoError if `path` cannot be written. Call it before the computation.
void check_picture_writable(const std::string& path, Existing existing = Existing::refuse);

/// The text of the picture.
std::string to_svg(const Picture& picture);

}  // namespace oblast::io
