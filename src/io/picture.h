// Pictures of operands and results, as SVG.
#pragma once

#include <oblast/region_set.h>

#include <string>
#include <vector>

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
  RegionView a;       ///< first operand, pale
  RegionView b;       ///< second operand, another pale colour; may be empty
  RegionView result;  ///< filled with a strong colour
  std::string title;
  std::string label_a = "A";
  std::string label_b = "B";
  std::string label_result = "result";
  MapProjection projection = MapProjection::plane;
  std::string unit = "units";  ///< of the coordinates of the plane, for the scale bar: "m", "ft"
  /// Rows by colour, in the order of the legend. If there are any, they are filled, and drawn in place of a and b.
  std::vector<PictureClass> classes = {};
};

/// An SVG with a title, a legend, axes and a scale bar. If details are smaller than a pixel, the main panel shows how
/// densely they cover each place, and a second panel shows the densest place enlarged. The text has at most about 4 MB
/// for any input: vertices are snapped to a tenth of a pixel or coarser. Texts may hold any bytes.
std::string to_svg(const Picture& picture);

}  // namespace oblast::io
