// The distance and the tolerance of `oblast buffer`, from words to numbers.
#pragma once

#include <oblast/buffer.h>

#include <string>
#include <vector>

#include "io/rows.h"
#include "oblast/length.h"

namespace oblast::app {

/// One length for all, or a column.
struct Distance {
  std::optional<Length> length;
  std::string column;  ///< if there is no length
};

/// Throws CallError.
Distance parse_distance(const std::string& word);

/// By row; one number if it is the same for all. Throws IoError if there is no such column, if it has no numbers, or if
/// a number is missing; CallError as in_units.
std::vector<double> distances(const Distance& distance, const io::Rows& rows, const io::CoordinateUnit& unit);

/// "2%" and "0.02" are relative, "0.5 m" is absolute. Throws CallError.
struct Tolerance {
  Length length{0.01, ""};

  bool is_absolute() const { return !length.unit.empty(); }
};
Tolerance parse_tolerance(const std::string& word);
void set_tolerance(BufferOptions& options, const Tolerance& tolerance, const io::CoordinateUnit& unit);

}  // namespace oblast::app
