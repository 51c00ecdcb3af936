// Two steps of the comparison of nearest objects with an oracle (bench/zones/oracle).
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace zones {

struct NearestFiles {
  std::string shapes, places;
  std::string rows;     ///< u32 by place: the object whose zone holds it
  std::string answers;  ///< of the oracle (sites.h)
};

/// Makes the zones, draws `count` places in the frame and about as many on borders and beside them, and writes places
/// and rows: a place that several zones hold once for each of them. "in_no_row" are places inside the frame that no
/// zone holds.
nlohmann::json write_places(const NearestFiles& files, std::uint64_t count, std::uint64_t seed, double tolerance);

/// Compares, exactly: the object of the row is at most as far as the oracle's site and `error` and `rounding`; that
/// site is at most as far as the object of the row and `rounding`. Places in polygons are at distance 0 from them.
nlohmann::json judge_answers(const NearestFiles& files, double error, double rounding);

}  // namespace zones
