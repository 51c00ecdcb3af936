// The layers of several files as one operand.
#include <algorithm>
#include <limits>

#include "io/read_parts.h"

namespace oblast::io {

namespace {

void add(ReadReport& sum, const ReadReport& part) {
  sum.features += part.features;
  sum.null_geometries += part.null_geometries;
  sum.empty_geometries += part.empty_geometries;
  sum.lines += part.lines;
  sum.points += part.points;
  sum.with_z += part.with_z;
  sum.with_m += part.with_m;
  sum.unclosed_contours += part.unclosed_contours;
  sum.repeated_vertices += part.repeated_vertices;
  sum.beyond_pole += part.beyond_pole;
  sum.across_date_line += part.across_date_line;
  sum.swapped += part.swapped;
}

void add_new(std::vector<std::string>& sum, const std::vector<std::string>& part) {
  for (const std::string& text : part) {
    if (std::find(sum.begin(), sum.end(), text) == sum.end()) sum.push_back(text);
  }
}

}  // namespace

namespace {

// `features` is the number of features before those of `part`.
void append(LinesAndPoints& sum, const LinesAndPoints& part, std::uint32_t features) {
  const auto vertices = static_cast<std::uint32_t>(sum.line_vertices.size());
  sum.line_vertices.insert(sum.line_vertices.end(), part.line_vertices.begin(), part.line_vertices.end());
  sum.points.insert(sum.points.end(), part.points.begin(), part.points.end());
  for (const std::uint32_t end : part.line_ends) sum.line_ends.push_back(vertices + end);
  for (const std::uint32_t feature : part.line_features) sum.line_features.push_back(features + feature);
  for (const std::uint32_t feature : part.point_features) sum.point_features.push_back(features + feature);
}

}  // namespace

void append_shapes(Layer& sum, const Layer& part) {
  append(sum.others, part.others, static_cast<std::uint32_t>(sum.features.size()));
  const auto points = static_cast<std::uint32_t>(sum.regions.points.size());
  const auto contours = static_cast<std::uint32_t>(sum.regions.contour_ends.size());
  const auto polygons = static_cast<std::uint32_t>(sum.regions.polygon_ends.size());
  const RegionSet& regions = part.regions;
  sum.regions.points.insert(sum.regions.points.end(), regions.points.begin(), regions.points.end());
  for (const std::uint32_t end : regions.contour_ends) sum.regions.contour_ends.push_back(points + end);
  for (const std::uint32_t end : regions.polygon_ends) sum.regions.polygon_ends.push_back(contours + end);
  for (FeatureRange feature : part.features) {
    feature.first_polygon += polygons;
    sum.features.push_back(feature);
  }
  for (const std::uint32_t contour : part.open_contours) sum.open_contours.push_back(contours + contour);
  add(sum.report, part.report);
}

namespace {

void append(Layer& sum, const Layer& part) {
  const auto files = static_cast<std::uint32_t>(sum.files.size());
  const std::size_t first = sum.features.size();
  append_shapes(sum, part);
  for (std::size_t f = first; f < sum.features.size(); ++f) sum.features[f].file += files;
  sum.files.insert(sum.files.end(), part.files.begin(), part.files.end());
  add_new(sum.columns, part.columns);
  add_new(sum.notes, part.notes);
}

void reserve(RegionSet& regions, const std::vector<FilePart>& parts) {
  std::size_t points = 0, contours = 0, polygons = 0, line_vertices = 0, single_points = 0;
  for (const FilePart& part : parts) {
    points += part.layer.regions.points.size();
    contours += part.layer.regions.contour_ends.size();
    polygons += part.layer.regions.polygon_ends.size();
    line_vertices += part.layer.others.line_vertices.size();
    single_points += part.layer.others.points.size();
  }
  if (std::max({points, line_vertices, single_points}) > std::numeric_limits<std::int32_t>::max())
    throw IoError("more than 2^31 - 1 vertices in one operand");
  regions.points.reserve(points);
  regions.contour_ends.reserve(contours);
  regions.polygon_ends.reserve(polygons);
}

}  // namespace

Layer join_layers(Parts& parts) {
  Layer sum;
  if (parts.files.size() == 1) {
    sum = std::move(parts.files.front().layer);
  } else {
    reserve(sum.regions, parts.files);
    for (FilePart& part : parts.files) {
      append(sum, part.layer);
      part.layer = {};  // frees its memory
    }
    sum.crs_wkt = parts.crs_wkt;
  }
  sum.notes.insert(sum.notes.begin(), parts.notes.begin(), parts.notes.end());
  return sum;
}

}  // namespace oblast::io
