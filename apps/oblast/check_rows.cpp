// Reads features as rows and verifies them; see check_rows.h.
#include "oblast/check_rows.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/formats.h"
#include "io/rows.h"
#include "oblast/command.h"
#include "oblast/console.h"
#include "oblast/no_polygons.h"
#include "verify/rows.h"

namespace oblast::app {

namespace {

// A record of a shapefile is read as one polygon with all its rings (gdal_reader.cpp). As we write them, an outer
// contour comes before its holes, and runs counter-clockwise after reading. So each of these begins a polygon. If that
// is wrong for a file, the check finds holes that are not in their outer contour.
io::Layer split_records(io::Layer layer) {
  const RegionView old = layer.regions;
  std::vector<std::uint32_t> polygon_ends, first_polygon;
  for (std::size_t p = 0; p < old.polygon_count(); ++p) {
    first_polygon.push_back(static_cast<std::uint32_t>(polygon_ends.size()));
    for (std::size_t c = old.polygon_begin(p); c < old.polygon_end(p); ++c) {
      const auto contour = old.contour(c);
      const std::uint32_t end[] = {static_cast<std::uint32_t>(contour.size())}, one[] = {1};
      const bool outer = signed_area(RegionView{contour, end, one}) > 0;
      const auto after = static_cast<std::uint32_t>(c + 1);
      if (outer || c == old.polygon_begin(p)) {
        polygon_ends.push_back(after);
      } else {
        polygon_ends.back() = after;
      }
    }
  }
  first_polygon.push_back(static_cast<std::uint32_t>(polygon_ends.size()));
  for (io::FeatureRange& feature : layer.features) feature.first_polygon = first_polygon[feature.first_polygon];
  layer.regions.polygon_ends = std::move(polygon_ends);
  return layer;
}

io::Layer read(const CheckInput& input, JobProgress& progress) {
  io::ReadOptions options;
  options.entries = io::FeatureEntries::all;
  io::Layer layer = read_to_check(input, options, progress);
  return io::lower_extension(input.file) == ".shp" ? split_records(std::move(layer)) : layer;
}

}  // namespace

std::string mended(const io::ReadReport& report) {
  if (report.repeated_vertices)
    return counted(report.repeated_vertices, "repeated vertex") + " in the file, dropped on reading";
  if (report.unclosed_contours)
    return counted(report.unclosed_contours, "unclosed contour") + " in the file, closed on reading";
  return {};
}

int check_rows(const CheckInput& input, ContourConvention convention, bool quiet, bool json) {
  const std::string& file = input.file;
  JobProgress progress(!quiet, false);
  const io::Layer layer = read(input, progress);
  if (layer.regions.contour_ends.empty()) progress.clear();
  if (!lines_and_points(layer.report).empty())
    if (const auto code = say_no_polygons(file, layer, json)) return *code;
  progress.show(Phase::computing, "proving", 0);
  const std::vector<std::uint32_t> ends = io::feature_ends(layer);
  const FeatureView rows{layer.regions, ends};
  const std::optional<verify::Fault> fault = verify::check_rows(rows, convention);
  progress.clear();
  const std::string note = mended(layer.report);
  std::string place;
  if (fault) place = io::describe(layer, fault->place);
  if (json) {
    nlohmann::ordered_json object{{"file", file},
                                  {"rows_fit", !fault},
                                  {"rows", layer.features.size()},
                                  {"polygons", rows.regions.polygon_count()},
                                  {"contours", rows.regions.contour_count()},
                                  {"vertices", rows.regions.points.size()}};
    if (fault) object["fault"] = {{"what", fault->what}, {"place", place}};
    if (!note.empty()) object["note"] = note;
    fmt::print("{}\n", object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else if (fault) {
    fmt::print("rows with a fault: {}\n  at {}\n", fault->what, place);
  } else {
    fmt::print("rows fit together: {}, {}, {}, {}\n", counted(layer.features.size(), "row"),
               counted(rows.regions.polygon_count(), "polygon"), counted(rows.regions.contour_count(), "contour"),
               counted(rows.regions.points.size(), "vertex"));
  }
  if (!json && !note.empty()) fmt::print("  note: {}\n", note);
  return fault ? exit_data : exit_done;
}

}  // namespace oblast::app
