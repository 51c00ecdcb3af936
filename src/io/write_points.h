// Writing a layer of points with a few columns, for a list of places.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "io/write.h"

namespace oblast::io {

/// A column of a point layer, with a value for each point.
struct PointColumn {
  std::string name;  ///< at most ten characters, as Shapefile has it
  std::variant<std::vector<std::string>, std::vector<std::int64_t>, std::vector<double>> values;
};

/// The integer that stands for no value.
inline constexpr std::int64_t no_value = -1;

/// Writes a point for each place. WKT has the points alone. Also an empty list is written. Throws IoError.
void write_points(const std::string& path, std::span<const Point> points, std::span<const PointColumn> columns,
                  const WriteOptions& options);

}  // namespace oblast::io
