// `oblast buffer`: the places within a distance of polygons, lines and points.
#include <fmt/format.h>
#include <oblast/buffer.h>
#include <oblast/oblast.h>

#include <algorithm>
#include <cmath>

#include "oblast/buffer_plan.h"
#include "oblast/buffer_plane.h"
#include "oblast/buffer_report.h"
#include "oblast/row_job.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
The zone of all polygons, lines and points together, as one row; with --by-feature a row
for each feature, with its attributes. A negative distance gives the places inside the
polygons that are further than that from their outlines. The zone is valid. Its outline is
as near to the true one as --tolerance says. The zone holds its input, or lies in it; with
bevels, flat caps or --crs there may be rounding in the last digits.

A distance without a unit is in the unit of the coordinates. Longitudes and latitudes
have no unit of length: with `--crs auto` such a layer is computed in a projected system
that fits it, and the zone comes back in longitudes and latitudes. `--crs EPSG:N` chooses
the system. Edges are straight in that system, so cut very long ones first.

A column as the distance holds numbers in the unit of the coordinates (with --crs: of that
system; for auto metres).

Example: everything within 500 m of a road
  oblast buffer roads.gpkg --distance 500m -o near.gpkg

Example: fields without a strip of 10 m along their outlines, field by field
  oblast buffer fields.gpkg --distance=-10m --by-feature -o inner.gpkg)";

struct Arguments {
  std::vector<std::string> inputs;
  std::string distance, tolerance = "1%", crs;
  bool by_feature = false;
  bool mitre_limit_given = false;
  BufferOptions options;
  JobArguments job;
  RowArguments rows;
};

void check(const Arguments& arguments) {
  if (!arguments.by_feature && !arguments.rows.select.empty())
    throw CallError("--select chooses the columns of features; add --by-feature to keep features as rows");
  if (arguments.mitre_limit_given && arguments.options.join != Join::mitre)
    throw CallError("--mitre-limit is for --join mitre");
}

void note_what_counts_not(const io::Layer& layer, const std::vector<double>& distances, const Arguments& arguments,
                          RowJob& job) {
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

int run(const Arguments& arguments, bool json) {
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

// An option with some words to choose from.
template <class Value>
void add_choice(CLI::App& command, const std::string& name, Value& value,
                std::vector<std::pair<std::string, Value>> words, const std::string& help, const std::string& type) {
  command
      .add_option_function<std::string>(
          name,
          [&value, words, name](const std::string& given) {
            std::string known;
            for (const auto& [word, meaning] : words) {
              if (word == given) {
                value = meaning;
                return;
              }
              known += (known.empty() ? "" : &word == &words.back().first ? " or " : ", ") + word;
            }
            throw CLI::ValidationError(name, fmt::format("there is no '{}'; choose {}", given, known));
          },
          help)
      ->type_name(type);
}

void add_shape_options(CLI::App& command, Arguments& arguments) {
  BufferOptions& options = arguments.options;
  command
      .add_option("--tolerance", arguments.tolerance,
                  "how far the outline may be from the true one: a share of the distance such as 0.01 or 1% "
                  "(default), or a length such as 0.5m")
      ->type_name("T");
  add_choice<Join>(command, "--join", options.join,
                   {{"round", Join::round}, {"mitre", Join::mitre}, {"bevel", Join::bevel}},
                   "the outline around corners: round (default), mitre or bevel", "JOIN");
  Arguments* const a = &arguments;
  command
      .add_option_function<double>(
          "--mitre-limit",
          [a](double limit) {
            if (!(limit >= 1 && std::isfinite(limit)))
              throw CLI::ValidationError("--mitre-limit", "the limit must be 1 or more");
            a->options.mitre_limit = limit;
            a->mitre_limit_given = true;
          },
          "with --join mitre: how far a corner may reach, as a multiple of the distance (default: 5)")
      ->type_name("M");
  add_choice<Cap>(command, "--cap", options.cap, {{"round", Cap::round}, {"flat", Cap::flat}, {"square", Cap::square}},
                  "the outline around the ends of lines: round (default), flat or square", "CAP");
  add_choice<Side>(command, "--side", options.side,
                   {{"both", Side::both}, {"left", Side::left}, {"right", Side::right}},
                   "the sides of lines, as seen along them: both (default), left or right", "SIDE");
  add_choice<BufferMode>(
      command, "--mode", options.mode,
      {{"nearest", BufferMode::nearest}, {"inside", BufferMode::inside}, {"outside", BufferMode::outside}},
      "where the outline may be: nearest (default, on both sides of the true one), inside (nothing further than the "
      "distance) or outside (nothing within the distance is missed)",
      "MODE");
}

}  // namespace

void add_buffer(CLI::App& program, Invocation& invocation) {
  const auto arguments = std::make_shared<Arguments>();
  Arguments* const a = arguments.get();
  CLI::App* command = program.add_subcommand("buffer", "All places within a distance of polygons, lines and points.");
  command->footer(footer);
  command->add_option("IN", a->inputs, input_help)->required()->type_name("");
  command
      ->add_option("--distance", a->distance,
                   "how far: a number with a unit (m, km, cm, ft, us-ft, mi, degrees) or in that of the coordinates; "
                   "or the name of a column of numbers")
      ->required()
      ->type_name("D");
  add_shape_options(*command, *a);
  command->add_flag("--by-feature", a->by_feature, "a row for each feature, with its attributes (default: one row)");
  command->add_option("--crs", a->crs, plane_help)->type_name("CRS");
  add_row_options(*command, a->rows, Select::columns);
  add_file_options(*command, a->job, invocation);
  command->remove_option(command->get_option("--minimal"));
  command->remove_option(command->get_option("--contours"));
  command->remove_option(command->get_option("--strict"));
  command->callback([arguments, &invocation] {
    invocation.run = [arguments, &invocation] { return run(*arguments, invocation.json); };
  });
}

}  // namespace oblast::app
