// Real layers, from GeoJSON. Does not need GDAL.
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "golden/inputs.h"
#include "golden/results.h"

namespace oblast::golden {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

void add_polygon(RegionSet& regions, const Json& rings) {
  for (const Json& ring : rings) {
    for (const Json& position : ring)
      regions.points.push_back({position.at(0).get<double>(), position.at(1).get<double>()});
    regions.contour_ends.push_back(static_cast<std::uint32_t>(regions.points.size()));
  }
  regions.polygon_ends.push_back(static_cast<std::uint32_t>(regions.contour_ends.size()));
}

RegionSet read(const fs::path& file) {
  std::ifstream stream(file);
  RegionSet regions;
  const Json collection = Json::parse(stream);
  for (const Json& feature : collection.at("features")) {
    const Json& geometry = feature.at("geometry");
    const Json& coordinates = geometry.at("coordinates");
    if (geometry.at("type") == "Polygon") {
      add_polygon(regions, coordinates);
    } else if (geometry.at("type") == "MultiPolygon") {
      for (const Json& polygon : coordinates) add_polygon(regions, polygon);
    } else {
      throw std::runtime_error(file.string() + ": neither Polygon nor MultiPolygon");
    }
  }
  return regions;
}

constexpr const char* pairs[][2] = {
    {"france-departements", "france-communes-normandie"},
    {"germany-outline-very-high", "germany-districts-high"},
    {"germany-districts-high", "germany-counties-medium"},
    {"italy-municipalities-r5", "italy-regions"},
};

}  // namespace

Family layers(const fs::path& folder) {
  Family family{"layers", "real layers: their unions, and all operations on some pairs", false, {}};
  if (!fs::is_directory(folder)) return family;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const fs::path& file = entry.path();
    if (file.extension() != ".geojson") continue;
    family.inputs.push_back(
        {file.stem().string(), [file] {
           return unions(read(file), {FillRule::polygons(), FillRule::at_least(2), FillRule::even_odd()});
         }});
  }
  for (const auto& [first, second] : pairs) {
    const fs::path a = folder / (first + std::string(".geojson")), b = folder / (second + std::string(".geojson"));
    if (!fs::exists(a) || !fs::exists(b)) continue;
    family.inputs.push_back(
        {first + std::string(" and ") + second, [a, b] { return four_operations(read(a), read(b), Options{}); }});
  }
  return family;
}

}  // namespace oblast::golden
