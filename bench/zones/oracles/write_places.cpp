#include "verify/edges.h"
#include "verify/rows.h"
#include "verify/zone_places.h"
#include "zones/oracles/nearest.h"
#include "zones/oracles/objects.h"

namespace zones {

using namespace oblast;

namespace {

/// Which rows hold a place.
verify::NumberedAreas areas_of(const FeatureSet& rows) {
  verify::NumberedAreas areas;
  for (std::uint32_t r = 0; r < rows.size(); ++r)
    for (const PolygonView polygon : verify::regions_of(rows, r).polygons()) areas.add(verify::boundary_of(polygon), r);
  areas.build();
  return areas;
}

}  // namespace

nlohmann::json write_places(const NearestFiles& files, std::uint64_t count, std::uint64_t seed, double tolerance) {
  const Objects objects(files.shapes);
  ZoneStatistics statistics;
  const FeatureSet rows = objects.zones(tolerance, statistics);
  const verify::ZoneObjects judged(objects.view());
  const verify::NumberedAreas areas = areas_of(rows);
  std::vector<buffers::Xy> places;
  std::vector<std::uint32_t> numbers;
  std::uint64_t in_no_row = 0;
  const Point &low = objects.frame().points[0], &high = objects.frame().points[2];
  const auto is_inside = [&](const Point& p) { return low.x < p.x && p.x < high.x && low.y < p.y && p.y < high.y; };
  for (const Point& p : verify::zone_places({judged, objects.frame(), rows, rows.keys}, count, seed)) {
    const std::vector<std::uint32_t> holders = areas.closed_at(p);
    in_no_row += holders.empty() && is_inside(p);
    for (const std::uint32_t row : holders) {
      places.push_back({p.x, p.y});
      numbers.push_back(row);
    }
  }
  std::ofstream out(files.places, std::ios::binary);
  buffers::transfer(out, std::vector<std::uint64_t>{places.size()});
  buffers::transfer(out, places);
  std::ofstream out_rows(files.rows, std::ios::binary);
  buffers::transfer(out_rows, numbers);
  if (!out || !out_rows) throw std::runtime_error("places cannot be written to " + files.places);
  return {{"objects", objects.size()}, {"sites", statistics.sites},       {"tolerance", statistics.tolerance},
          {"error", statistics.error}, {"rounding", statistics.rounding}, {"places", places.size()},
          {"in_no_row", in_no_row}};
}

}  // namespace zones
