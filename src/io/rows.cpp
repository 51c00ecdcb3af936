// Polygons and attributes, in one pass over each file; see rows.h.
#include "io/rows.h"

#include "io/read_parts.h"

namespace oblast::io {

std::vector<std::uint32_t> feature_ends(const Layer& layer) {
  std::vector<std::uint32_t> ends;
  ends.reserve(layer.features.size());
  for (std::size_t f = 1; f < layer.features.size(); ++f) ends.push_back(layer.features[f].first_polygon);
  if (!layer.features.empty()) ends.push_back(static_cast<std::uint32_t>(layer.regions.polygon_ends.size()));
  return ends;
}

Rows read_rows(std::span<const std::string> paths, ReadOptions options, std::vector<std::string>& notes) {
  options.entries = FeatureEntries::all;
  Parts parts = read_parts(paths, options, Attributes::keep);
  Rows rows;
  rows.table = join_tables(parts, notes);
  rows.layer = join_layers(parts);
  rows.ends = feature_ends(rows.layer);
  return rows;
}

}  // namespace oblast::io
