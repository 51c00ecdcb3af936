#include "oblast/length.h"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <string_view>
#include <utility>

#include "oblast/command.h"

namespace oblast::app {

namespace {

constexpr std::pair<std::string_view, double> metres_of_unit[] = {
    {"m", 1},         {"km", 1000},  {"cm", 0.01},  {"ft", 0.3048},   {"us-ft", 1200.0 / 3937},
    {"mi", 1609.344}, {"metres", 1}, {"meters", 1}, {"feet", 0.3048}, {"miles", 1609.344},
};
constexpr std::string_view degree_words[] = {"degrees", "degree", "deg"};

double metres_of(const std::string& unit) {
  for (const auto& [name, metres] : metres_of_unit)
    if (name == unit) return metres;
  return 0;
}

}  // namespace

std::string known_units() { return "m, km, cm, ft, us-ft, mi, degrees, units"; }

bool is_degrees(const Length& length) {
  for (const std::string_view word : degree_words)
    if (length.unit == word) return true;
  return false;
}

std::optional<Length> parse_length(const std::string& word) {
  const auto skip_space = [&](const char* at) {
    while (at != word.data() + word.size() && *at == ' ') ++at;
    return at;
  };
  const char* const past = word.data() + word.size();
  const char* at = skip_space(word.data());
  if (at != past && *at == '+') ++at;
  const char* const digits = at != past && *at == '-' ? at + 1 : at;
  const bool is_number = digits != past && (std::isdigit(static_cast<unsigned char>(*digits)) || *digits == '.');
  if (!is_number) return {};  // "inf" may be the name of a column
  Length length;
  const auto [rest, error] = std::from_chars(at, past, length.number);
  if (error != std::errc()) return {};
  length.unit = std::string(skip_space(rest), past);
  while (length.unit.ends_with(' ')) length.unit.pop_back();
  const bool known = length.unit.empty() || length.unit == "%" || length.unit == "units" ||
                     metres_of(length.unit) > 0 || is_degrees(length);
  if (!known) throw CallError(fmt::format("'{}': {} is not a unit; choose from {}", word, length.unit, known_units()));
  return length;
}

double in_units(const Length& length, const io::CoordinateUnit& unit) {
  constexpr double turn = 360;
  if (length.unit.empty() || length.unit == "units") return length.number;
  if (is_degrees(length)) {
    if (!unit.angle) throw CallError("the coordinates are not degrees; give the distance as a length, such as 500m");
    return length.number * unit.full_turn / turn;
  }
  if (unit.metres == 0)
    throw CallError(fmt::format(
        "the files do not say how long a unit of the coordinates is, so {} {} is unknown; leave out the unit to give "
        "the distance in units of the coordinates, or name the coordinate system with --assume-crs",
        length.number, length.unit));
  return length.number * metres_of(length.unit) / unit.metres;
}

}  // namespace oblast::app
