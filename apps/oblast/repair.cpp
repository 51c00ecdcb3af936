// `oblast repair`: features made valid one by one, or all of them together made a coverage.
#include <fmt/format.h>
#include <oblast/repair.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "oblast/check_input.h"
#include "oblast/repair_report.h"
#include "oblast/row_job.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
Each feature that is not valid becomes the region that its rings mean: its polygons
united, each filled by even-odd of its rings. Valid features keep their vertices as they
are. All columns are kept, and so is the order of the rows.

With --coverage features no longer overlap, and borders that they share have the same
vertices. A piece that several features cover goes to the first of them, or to the
largest. A gap is an enclosed piece that no feature covers; a sliver is a part of a
feature, but never its largest part. Small ones go to the feature with which they share
the longest border. The width of a piece is twice its area divided by its perimeter.
Areas and widths are in the units of the coordinates; `inf` closes everything.

A feature that has no area, or that lost all of it, keeps its row, without a geometry.
With --drop-empty such rows are left out.

Example: communes with small overlaps and gaps
  oblast repair communes.gpkg -o clean.gpkg --coverage --overlaps largest --gaps-below 50)";

struct Arguments {
  std::vector<std::string> inputs;
  JobArguments job;
  RowArguments rows;
  bool coverage = false, drop_empty = false;
  CoverageRepairOptions options;
  std::vector<std::string> for_coverage;  ///< options given that need --coverage
};

void check(const Arguments& arguments) {
  if (!arguments.coverage && !arguments.for_coverage.empty())
    throw CallError(arguments.for_coverage.front() + " is for coverages; add --coverage");
}

/// What the pipeline counts in other commands.
void count(const FeatureView& before, const FeatureSet& after, Statistics& statistics) {
  statistics.input_contours = before.regions.contour_count();
  statistics.input_vertices = before.regions.points.size();
  statistics.output_polygons = after.regions.polygon_ends.size();
  statistics.output_contours = after.regions.contour_ends.size();
  statistics.output_vertices = after.regions.points.size();
}

/// Repairs; what was changed goes into the report.
FeatureSet repaired(RowJob& job, const Arguments& arguments, RepairReport& report) {
  const io::Rows& layer = job.layers().front();
  FeatureSet rows;
  job.compute([&](const Options& options) {
    const std::vector<std::uint32_t> without_roles = features_without_roles(layer.layer);
    FeatureSet grouped;
    if (!without_roles.empty()) grouped = group_rings(layer.view(), without_roles, options);
    const FeatureView before = without_roles.empty() ? layer.view() : FeatureView(grouped);
    if (arguments.coverage) {
      CoverageRepairOptions repair_options = arguments.options;
      static_cast<CallOptions&>(repair_options) = options;
      RepairedCoverage result = repair_coverage(before, repair_options);
      report.add(result);
      rows = std::move(result.features);
    } else {
      RepairOptions repair_options;
      static_cast<CallOptions&>(repair_options) = options;
      Repaired result = repair(before, repair_options);
      report.add(result);
      rows = std::move(result.features);
    }
    count(before, rows, *options.statistics);
  });
  return rows;
}

std::uint32_t polygons_of(const FeatureSet& rows, std::uint32_t row) {
  return rows.feature_ends[row] - (row == 0 ? 0 : rows.feature_ends[row - 1]);
}

int run(const Arguments& arguments, bool json) {
  check(arguments);
  RowJob job("repair", {{"input", arguments.inputs}}, arguments.job, arguments.rows, json);
  const io::Rows& layer = job.layers().front();
  RepairReport report(layer);
  FeatureSet rows = repaired(job, arguments, report);

  std::vector<std::uint32_t> kept, ends;
  for (std::uint32_t row = 0; row < rows.size(); ++row) {
    const bool empty = polygons_of(rows, row) == 0;
    if (empty) report.add_empty(row);
    if (empty && arguments.drop_empty) continue;
    kept.push_back(row);
    ends.push_back(rows.feature_ends[row]);
  }
  report.set_dropped(rows.size() - kept.size());
  rows.feature_ends = std::move(ends);

  ResultColumns columns;
  for (const std::size_t c : selected(layer.table, arguments.rows.select)) columns.join(layer.table, c, kept);
  job.add_to_summary(report.to_json(), false);
  const int code = job.finish(rows, std::move(columns), {"repair", ""});
  if (!json && !arguments.job.quiet) fmt::print(stderr, "{}", report.to_text());
  return code;
}

void add_coverage_options(CLI::App& command, Arguments& arguments) {
  Arguments* const a = &arguments;
  command.add_flag("--coverage", a->coverage, "make all features together a coverage");
  command
      .add_option_function<std::string>(
          "--overlaps",
          [a](const std::string& word) {
            if (word != "first" && word != "largest")
              throw CLI::ValidationError("--overlaps", word + " is not a rule; choose first or largest");
            a->options.overlaps = word == "first" ? OverlapRule::first : OverlapRule::largest;
            a->for_coverage.emplace_back("--overlaps");
          },
          "with --coverage: who gets what several features cover: first (default) or largest")
      ->type_name("RULE");
  const auto add_bound = [&](const char* name, double& bound, const char* what, const char* unit) {
    command
        .add_option_function<double>(
            name,
            [a, name, &bound](double value) {
              if (!(value >= 0)) throw CLI::ValidationError(name, "the bound must be 0 or more");
              bound = value;
              a->for_coverage.emplace_back(name);
            },
            what)
        ->type_name(unit);
  };
  add_bound("--gaps-below", a->options.gaps_below, "with --coverage: close gaps with less area (default: none)",
            "AREA");
  add_bound("--gaps-narrower", a->options.gaps_narrower, "with --coverage: close gaps of less width", "WIDTH");
  add_bound("--slivers-below", a->options.slivers_below, "with --coverage: move slivers with less area", "AREA");
  add_bound("--slivers-narrower", a->options.slivers_narrower, "with --coverage: move slivers of less width", "WIDTH");
}

}  // namespace

void add_repair(CLI::App& program, Invocation& invocation) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      program.add_subcommand("repair", "Make features valid, or make a coverage of them; attributes are kept.");
  command->footer(footer);
  command->add_option("IN", arguments->inputs, input_help)->required()->type_name("");
  add_coverage_options(*command, *arguments);
  command->add_flag("--drop-empty", arguments->drop_empty, "leave out rows without a geometry");
  add_row_options(*command, arguments->rows, Select::columns);
  add_file_options(*command, arguments->job, invocation);
  // Valid features keep their vertices, and all results are valid in every GIS.
  command->remove_option(command->get_option("--minimal"));
  command->remove_option(command->get_option("--contours"));
  // Areas of rows are measured by the directions of rings, which valid features keep.
  command->remove_option(command->get_option("--area"));
  command->callback([arguments, &invocation] {
    invocation.run = [arguments, &invocation] { return run(*arguments, invocation.json); };
  });
}

}  // namespace oblast::app
