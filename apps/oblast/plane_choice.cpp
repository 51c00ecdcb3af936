#include "oblast/plane_choice.h"

#include <fmt/format.h>

#include "io/crs.h"
#include "io/working_crs.h"
#include "oblast/command.h"

namespace oblast::app {

namespace {

[[noreturn]] void refuse_degrees(const io::Layer& layer, const PlaneQuery& query) {
  throw CallError(fmt::format(
      "the coordinates are longitudes and latitudes ({}), so {} a projected system: a degree is 111 km "
      "from south to north, but from west to east 111 km at the equator, 56 km at 60 degrees of latitude and nothing "
      "at a pole. Add `--crs auto` to compute in a system that fits the layer and come back, `--crs EPSG:N` to choose "
      "that system, or `--t_srs EPSG:N` to stay in it. If degrees are meant, write {}",
      io::crs_name(layer.crs_wkt), query.what, query.example));
}

}  // namespace

std::string parse_plane(const std::string& word) {
  if (word.empty() || word == "auto") return word;
  std::string wkt;
  try {
    wkt = io::crs_from_text(word);
  } catch (const io::IoError& error) {
    throw CallError(std::string("--crs: ") + error.what() + "; or `auto`");
  }
  if (io::coordinate_unit(wkt).angle)
    throw CallError(
        fmt::format("--crs {}: {} has degrees, in which no distance can be measured; name a projected "
                    "system, or `auto`",
                    word, io::crs_name(wkt)));
  return wkt;
}

PlaneChoice choose_plane(const io::Layer& layer, const PlaneQuery& query) {
  const io::CoordinateUnit unit = io::coordinate_unit(layer.crs_wkt);
  if (query.crs.empty()) {
    if (unit.angle && !query.in_degrees) refuse_degrees(layer, query);
    return {};
  }
  if (query.in_degrees)
    throw CallError("--crs is for lengths in units of length; leave it out, or write --distance 500m");
  if (layer.crs_wkt.empty())
    throw CallError("--crs: the files name no coordinate system; say with --assume-crs in which one they are");
  if (query.crs != "auto") return {io::same_crs(query.crs, layer.crs_wkt) ? "" : query.crs, ""};
  if (!unit.angle)
    return {"", fmt::format("--crs auto: {} is projected already; computed in it", io::crs_name(layer.crs_wkt))};
  const io::WorkingCrs working = io::suitable_crs(layer.crs_wkt, query.extent, query.reach);
  constexpr double large = 0.02, percent = 100;
  return {working.wkt, fmt::format("{}computed in {}, where lengths are true to about {:.2g} %",
                                   working.scale_error > large ? "warning: " : "", io::crs_name(working.wkt),
                                   percent * working.scale_error)};
}

}  // namespace oblast::app
