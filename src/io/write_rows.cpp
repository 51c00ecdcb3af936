// Chooses the writer; see write_rows.h.
#include "io/write_rows.h"

#include <fmt/format.h>

#include "io/formats.h"
#include "io/row_writers.h"
#include "io/write_text.h"

namespace oblast::io {

namespace {

// The polygons of one row, as a region set of their own.
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

}  // namespace

std::string rows_to_wkt(const FeatureView& rows) {
  std::string text;
  for (std::size_t row = 0; row < rows.feature_count(); ++row) text += to_wkt(regions_of(rows, row)) + "\n";
  return text;
}

void write_rows(const std::string& path_given, const FeatureView& rows, std::span<const OutputColumn> columns,
                const WriteOptions& options, std::vector<std::string>& notes) {
  check_writable(path_given, options);
  if (is_wkt(path_given) && !columns.empty())
    notes.push_back(fmt::format("WKT has no attributes; {} {} left out", columns.size(),
                                columns.size() == 1 ? "column is" : "columns are"));
  if (path_given == "-") return write_text_to_standard_output(rows_to_wkt(rows));
  const std::string path = target_of(path_given);
  const RowOutput output{rows, columns, options.crs_wkt, path};
  write_staged(path, options.existing, [&](const std::string& stage) {
    if (const char* driver = format_of(path)->writer) {
      write_rows_with_gdal(stage, driver, output, notes);
    } else if (is_geojson(path)) {
      write_text(stage, rows_to_geojson(output, notes), path);
    } else {
      write_text(stage, rows_to_wkt(rows), path);
    }
  });
}

}  // namespace oblast::io
