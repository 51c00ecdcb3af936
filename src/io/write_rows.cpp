// Chooses the writer; see write_rows.h.
#include "io/write_rows.h"

#include <fmt/format.h>
#include <oblast/wkb.h>

#include <filesystem>

#include "io/formats.h"
#include "io/row_writers.h"
#include "io/write_text.h"

namespace oblast::io {

RegionSet regions_of(const FeatureView& rows, std::size_t row) {
  RegionSet regions;
  for (std::size_t p = rows.feature_begin(row); p < rows.feature_end(row); ++p) {
    for (std::size_t c = rows.regions.polygon_begin(p); c < rows.regions.polygon_end(p); ++c) {
      const auto contour = rows.regions.contour(c);
      regions.points.insert(regions.points.end(), contour.begin(), contour.end());
      regions.contour_ends.push_back(static_cast<std::uint32_t>(regions.points.size()));
    }
    regions.polygon_ends.push_back(static_cast<std::uint32_t>(regions.contour_ends.size()));
  }
  return regions;
}

std::string rows_to_wkt(const FeatureView& rows) {
  std::string text;
  for (std::size_t row = 0; row < rows.feature_count(); ++row) text += to_wkt(regions_of(rows, row)) + "\n";
  return text;
}

std::string rows_to_wkb(const FeatureView& rows) {
  std::string text;
  for (std::size_t row = 0; row < rows.feature_count(); ++row) {
    const std::vector<std::byte> bytes = to_wkb(regions_of(rows, row));
    text.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  }
  return text;
}

namespace {

std::string to_text(const RowOutput& output, TextFormat format, std::vector<std::string>& notes) {
  if (format == TextFormat::geojson) return rows_to_geojson(output, notes);
  const bool wkt = format == TextFormat::wkt;
  if (!output.columns.empty())
    notes.push_back(fmt::format("{} has no attributes; {} {} left out", wkt ? "WKT" : "WKB", output.columns.size(),
                                output.columns.size() == 1 ? "column is" : "columns are"));
  return wkt ? rows_to_wkt(output.rows) : rows_to_wkb(output.rows);
}

void write_csv(const std::string& stage, const RowOutput& output, std::vector<std::string>& notes) {
  const CsvText csv = rows_to_csv(output, notes);
  write_text(std::filesystem::path(stage).replace_extension(".csvt").string(), csv.types, output.name);
  write_text(stage, csv.table, output.name);
}

}  // namespace

void write_rows(const std::string& path_given, const FeatureView& rows, std::span<const OutputColumn> columns,
                const WriteOptions& options_given, std::vector<std::string>& notes) {
  check_writable(path_given, options_given);
  const OutputTarget target = output_target(path_given);
  WriteOptions options = options_given;
  options.notes = &notes;
  const RowOutput output{rows, columns, options.crs_wkt, target.path, options.progress};
  if (path_given == "-") return write_text_to_standard_output(to_text(output, options.standard_output, notes));
  write_staged(target, options, [&](const std::string& stage) {
    if (const char* driver = format_of(target.path)->writer) {
      write_rows_with_gdal({stage, driver, target.layer_name(), options.crs_wkt, target.path}, output,
                           GeopackageShape::multipolygon, notes);
    } else if (is_csv(target.path)) {
      write_csv(stage, output, notes);
    } else {
      write_text(stage, to_text(output, text_format_of(target.path), notes), target.path);
    }
  });
}

}  // namespace oblast::io
