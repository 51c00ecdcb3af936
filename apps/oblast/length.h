// Lengths as users write them: "500 m", "0.5 km", "30", "0.1 degrees", "2%".
#pragma once

#include <optional>
#include <string>

#include "io/working_crs.h"

namespace oblast::app {

/// A number, and a unit: m, km, cm, ft, us-ft, mi, degrees, units (those of the coordinates), % or none.
struct Length {
  double number = 0;
  std::string unit;
};

/// Nothing if the word does not begin with a number. Throws CallError for a unit that is none of these.
std::optional<Length> parse_length(const std::string& word);

/// "m, km, ..." for messages.
std::string known_units();

bool is_degrees(const Length& length);

/// The length in units of coordinates. Without a unit it is in these already. Throws CallError if one is an angle and
/// the other is not, or if the unit of the coordinates is not known.
double in_units(const Length& length, const io::CoordinateUnit& unit);

}  // namespace oblast::app
