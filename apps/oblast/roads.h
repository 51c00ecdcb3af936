// A network of roads as maps of towns and country have it: lines for measurements, by a seed.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <string>
#include <vector>

namespace oblast::app {

inline constexpr const char* roads_crs = "EPSG:3035";

struct RoadNetwork {
  std::vector<Point> vertices;      ///< in metres of `roads_crs`, rounded to centimetres
  std::vector<std::uint32_t> ends;  ///< line l is [ends[l-1], ends[l])
  std::vector<std::string> kinds;   ///< by line: "street" or "road"

  std::size_t segments() const { return vertices.size() - ends.size(); }
};

/// A network of exactly `segments` segments. Towns lie on a grid of 5 km, each somewhere in its cell. A town is a grid
/// of streets at an angle of its own, with blocks of 50 to 120 m, some of which are joined; a winding road leads from
/// its east side to the next town, and one from its north side. The same on every machine: the only operations are
/// + - * / and sqrt. The towns of a smaller network are the first ones of a larger one of as many columns.
RoadNetwork generate_roads(std::uint32_t segments, std::uint64_t seed);

}  // namespace oblast::app
