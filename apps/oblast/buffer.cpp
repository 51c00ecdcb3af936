// `oblast buffer`: the places within a distance of polygons, lines and points.
#include <fmt/format.h>
#include <oblast/buffer.h>
#include <oblast/oblast.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "oblast/buffer_options.h"
#include "oblast/buffer_plan.h"
#include "oblast/buffer_plane.h"
#include "oblast/buffer_report.h"
#include "oblast/row_job.h"

namespace oblast::app {

namespace {

void check(const BufferArguments& arguments) {
  if (!arguments.by_feature && !arguments.rows.select.empty())
    throw CallError("--select chooses the columns of features; add --by-feature to keep features as rows");
  if (arguments.mitre_limit_given && arguments.options.join != Join::mitre)
    throw CallError("--mitre-limit is for --join mitre");
}

void note_what_counts_not(const io::Layer& layer, const std::vector<double>& distances,
                          const BufferArguments& arguments, RowJob& job) {
  const io::LinesAndPoints& others = layer.others;
  if (arguments.options.side != Side::both && others.line_ends.empty())
    job.note("--side is for lines, and there are none");
  const bool shrinks = std::any_of(distances.begin(), distances.end(), [](double d) { return d < 0; });
  const bool any = !others.line_ends.empty() || !others.points.empty();
  if (shrinks && any) job.note("lines and points count as nothing where the distance is negative");
}

// One row for all; none if nothing is left.
FeatureSet one_row(RegionSet regions) {
  FeatureSet rows;
  if (!regions.polygon_ends.empty()) {
    rows.feature_ends.push_back(static_cast<std::uint32_t>(regions.polygon_ends.size()));
    rows.keys.push_back({0, no_feature});
  }
  rows.regions = std::move(regions);
  return rows;
}

FeatureSet zones_of(const BufferPlane& plane, const std::vector<double>& distances, const BufferOptions& options,
                    bool by_feature, std::size_t row_count) {
  if (distances.size() == 1 && !by_feature)
    return one_row(plane.back(buffer(plane.shapes().shapes, distances.front(), options), options));
  const std::vector<double> same(row_count, distances.empty() ? 0 : distances.front());
  FeatureSet zones = buffer_rows(plane.shapes(), distances.size() == row_count ? distances : same, options);
  if (by_feature) return plane.back(std::move(zones), options);
  Options uniting;
  static_cast<CallOptions&>(uniting) = options;
  return one_row(plane.back(unite(zones.regions, uniting), options));
}

void count(const FeatureView& rows, Statistics& statistics) {
  statistics.output_polygons = rows.regions.polygon_count();
  statistics.output_contours = rows.regions.contour_count();
  statistics.output_vertices = rows.regions.points.size();
}

int run(const BufferArguments& arguments, bool json) {
  check(arguments);
  const BufferPlan plan = buffer_plan(arguments.distance, arguments.tolerance, arguments.crs);
  RowJob job("buffer", {{.label = "input", .paths = arguments.inputs, .where = {}, .keep_others = true}}, arguments.job,
             arguments.rows, json);
  const io::Rows& rows = job.layers().front();
  const PlaneChoice choice = choose_plane(plan, rows);
  if (!choice.note.empty()) job.note(choice.note);
  const BufferPlane plane(rows, choice.crs_wkt);
  const std::vector<double> by_row = distances(plan.distance, rows, plane.unit());
  BufferOptions options = arguments.options;
  set_tolerance(options, plan.tolerance, plane.unit());
  note_what_counts_not(rows.layer, by_row, arguments, job);

  BufferReport report;
  FeatureSet zones;
  job.compute([&](const Options& common) {
    static_cast<CallOptions&>(options) = common;
    options.statistics = &report.statistics;
    zones = zones_of(plane, by_row, options, arguments.by_feature, rows.ends.size());
    count(zones, report.statistics.overlay);
    *common.statistics = report.statistics.overlay;
  });
  if (zones.regions.points.empty()) job.note("nothing is left: the zone is empty");

  ResultColumns columns;
  std::vector<std::uint32_t> same(rows.ends.size());
  for (std::uint32_t row = 0; row < same.size(); ++row) same[row] = row;
  if (arguments.by_feature)
    for (const std::size_t c : selected(rows.table, arguments.rows.select)) columns.join(rows.table, c, same);
  report.describe(by_row, plane.crs());
  job.add_to_summary(report.to_json(), true);
  const int code = job.finish(zones, std::move(columns), {"buffer", ""});
  if (!json && !arguments.job.quiet) fmt::print(stderr, "{}", report.to_text());
  return code;
}

}  // namespace

void add_buffer(CLI::App& program, Invocation& invocation) {
  const auto arguments = std::make_shared<BufferArguments>();
  add_buffer_options(program, *arguments, invocation)->callback([arguments, &invocation] {
    invocation.run = [arguments, &invocation] { return run(*arguments, invocation.json); };
  });
}

}  // namespace oblast::app
