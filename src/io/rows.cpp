// Geometry first, then the attributes; see rows.h.
#include "io/rows.h"

#include "io/paths.h"

namespace oblast::io {

std::vector<std::uint32_t> feature_ends(const Layer& layer) {
  std::vector<std::uint32_t> ends;
  ends.reserve(layer.features.size());
  for (std::size_t f = 1; f < layer.features.size(); ++f) ends.push_back(layer.features[f].first_polygon);
  if (!layer.features.empty()) ends.push_back(static_cast<std::uint32_t>(layer.regions.polygon_ends.size()));
  return ends;
}

Rows read_rows(std::span<const std::string> paths, ReadOptions options, std::vector<std::string>& notes) {
  const std::vector<std::string> files = expand_paths(paths);
  options.entries = FeatureEntries::all;
  Rows rows;
  rows.layer = read(files, options);
  rows.ends = feature_ends(rows.layer);
  rows.table = read_attributes(files, options.where, rows.layer, notes);
  return rows;
}

}  // namespace oblast::io
