// Pictures of operands and results, as SVG.
#pragma once

#include <oblast/region_set.h>

#include <cstdint>
#include <span>
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

/// The colour of lines, and of points that are an operand.
inline constexpr const char* colour_of_lines = "#1b4f77";

/// Lines of the first operand, drawn over the regions.
struct PictureLines {
  std::span<const Point> vertices;
  std::span<const std::uint32_t> ends;  ///< line l is [ends[l-1], ends[l])
};

/// Points of one kind, drawn as dots over everything else.
struct PictureMarks {
  std::vector<Point> points;
  std::string colour;
  std::string label;  ///< for the legend
  double size = 5;    ///< of a dot in pixels
};

struct Picture {
  RegionView a;       ///< first operand, pale
  RegionView b;       ///< second operand, another pale colour; may be empty
  RegionView result;  ///< filled with a strong colour; not in the legend if it has no label
  std::string title;
  std::string label_a = "A";
  std::string label_b = "B";
  std::string label_result = "result";
  MapProjection projection = MapProjection::plane;
  std::string unit = "units";  ///< of the coordinates of the plane, for the scale bar: "m", "ft"
  /// Rows by colour, in the order of the legend. If there are any, they are filled, and drawn in place of a and b.
  std::vector<PictureClass> classes = {};
  PictureLines lines = {};
  std::vector<PictureMarks> marks = {};  ///< the last ones lie on top
};

/// An SVG with a title, a legend, axes and a scale bar. If details are smaller than a pixel, the main panel shows how
/// densely they cover each place, and a second panel shows the densest place enlarged: of the largest marks, if there
/// are any. The text has at most about 4 MB for any input, and half a megabyte more for each kind of marks: vertices
/// are snapped to a tenth of a pixel or coarser. Texts may hold any bytes.
std::string to_svg(const Picture& picture);

}  // namespace oblast::io
