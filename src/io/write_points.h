// Writing a layer of points or of lines with a few columns.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "io/write.h"

namespace oblast::io {

/// A column of such a layer, with a value for each point or line.
struct PlaceColumn {
  std::string name;  ///< at most ten characters, as Shapefile has it
  std::variant<std::vector<std::string>, std::vector<std::int64_t>, std::vector<double>> values;
};

/// The integer that stands for no value.
inline constexpr std::int64_t no_value = -1;

/// Writes a point for each place. WKT has the points alone. Also an empty list is written. Throws IoError.
void write_points(const std::string& path, std::span<const Point> points, std::span<const PlaceColumn> columns,
                  const WriteOptions& options);

/// Line l has the vertices [ends[l-1], ends[l]), at least two.
struct LineView {
  std::span<const Point> vertices;
  std::span<const std::uint32_t> ends;
};
/// The same for lines.
void write_lines(const std::string& path, const LineView& lines, std::span<const PlaceColumn> columns,
                 const WriteOptions& options);

}  // namespace oblast::io
