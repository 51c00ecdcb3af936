// `oblast zones`: the places to which an object is the nearest one, as a coverage.
#include <fmt/format.h>
#include <oblast/zones.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <numeric>

#include "io/row_colours.h"
#include "oblast/aggregate.h"
#include "oblast/buffer_plane.h"
#include "oblast/console.h"
#include "oblast/zones_plan.h"
#include "oblast/zones_report.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
A zone is the places to which no other object is nearer. Objects are the features of IN:
points, lines, polygons, or several of these. Each row of the result is a feature, with its
attributes and its zone. With --by, all features with the same value are one object, and
the rows are as those of `oblast dissolve`.

Zones fill the polygons of --within; without it, a box around all objects, with a margin of
a tenth of its larger side. They leave no gap, do not overlap, and share their borders, bit
for bit: `oblast check --coverage` finds no fault. Each object lies in its own zone. Where
polygons overlap, the first one has the place.

Borders are as exact as --tolerance says: at any place of a zone no other object is nearer
by more. Of points they are exact, up to rounding. With --distance, zones end there.

Longitudes and latitudes have no unit of length: with `--crs auto` such a layer is computed
in a projected system that fits it, and comes back in longitudes and latitudes. Edges are
straight in that system, so cut very long ones first.

Example: which school is the nearest, in each place of the city
  oblast zones schools.gpkg --within city.gpkg -o served.gpkg --area m2

Example: the land around each building, at most 100 m from it, to 1 cm
  oblast zones buildings.gpkg --distance 100m --tolerance 1cm -o plots.gpkg)";

struct Arguments {
  std::vector<std::string> inputs, by;
  std::string within, where_within, tolerance, distance, crs;
  JobArguments job;
  RowArguments rows;
};

std::vector<RowInput> inputs_of(const Arguments& arguments) {
  if (!arguments.where_within.empty() && arguments.within.empty())
    throw CallError("--where-within is for the features of --within; add it");
  std::vector<RowInput> inputs{{.label = "input", .paths = arguments.inputs, .where = {}, .keep_others = true}};
  if (!arguments.within.empty())
    inputs.push_back({.label = "frame", .paths = {arguments.within}, .where = arguments.where_within});
  return inputs;
}

// The object of each feature.
Groups objects_of(const Arguments& arguments, const RowJob& job) {
  const io::Rows& rows = job.layers().front();
  std::vector<std::size_t> by;
  for (const std::string& name : arguments.by) {
    check_column(name, {&rows, 1});
    by.push_back(*rows.table.find(name));
  }
  if (!by.empty()) return group_rows(rows.table, by);
  Groups each;
  each.group_of_row.resize(rows.ends.size());
  std::iota(each.group_of_row.begin(), each.group_of_row.end(), 0U);
  for (std::uint32_t row = 0; row < rows.ends.size(); ++row) each.rows.push_back({row});
  return each;
}

ResultColumns columns_of(const Arguments& arguments, const io::AttributeTable& table, const Groups& objects) {
  ResultColumns columns;
  auto& first = columns.indices.emplace_back();
  for (const std::vector<std::uint32_t>& rows : objects.rows) first.push_back(rows.front());
  for (const std::string& name : arguments.by) columns.join(table, *table.find(name), first);
  for (const std::size_t c : selected(table, arguments.rows.select)) {
    const std::string& name = table.columns()[c].name;
    if (arguments.by.empty())
      columns.join(table, c, first);
    else if (std::find(arguments.by.begin(), arguments.by.end(), name) == arguments.by.end())
      add_aggregate(table, c, Aggregation::first, name, objects, columns);
  }
  return columns;
}

// Shapes whose numbers are those of objects, in place of features.
class Numbered {
 public:
  Numbered(const BufferPlane& plane, const Groups& objects) : features_(plane.shapes()) {
    const std::span<const std::uint32_t> of_shapes[] = {features_.region_rows, features_.line_rows,
                                                        features_.point_rows};
    for (std::size_t kind = 0; kind < 3; ++kind)
      for (const std::uint32_t row : of_shapes[kind]) numbers_[kind].push_back(objects.group_of_row[row]);
    features_.region_rows = numbers_[0];
    features_.line_rows = numbers_[1];
    features_.point_rows = numbers_[2];
  }
  Numbered(const Numbered&) = delete;
  Numbered& operator=(const Numbered&) = delete;

  const ShapeFeatures& features() const { return features_; }

 private:
  ShapeFeatures features_;
  std::vector<std::uint32_t> numbers_[3];
};

// A row for each object, also for the last ones if they have no shape.
void complete(FeatureSet& zones, std::size_t objects) {
  for (std::uint32_t row = static_cast<std::uint32_t>(zones.size()); row < objects; ++row) {
    zones.feature_ends.push_back(static_cast<std::uint32_t>(zones.regions.polygon_ends.size()));
    zones.keys.push_back({row, no_feature});
  }
}

std::uint64_t empty_rows(const FeatureView& rows) {
  std::uint64_t count = 0;
  for (std::size_t row = 0; row < rows.feature_count(); ++row)
    count += rows.feature_begin(row) == rows.feature_end(row) ? 1 : 0;
  return count;
}

void count(const FeatureView& rows, Statistics& statistics) {
  statistics.output_polygons = rows.regions.polygon_count();
  statistics.output_contours = rows.regions.contour_count();
  statistics.output_vertices = rows.regions.points.size();
}

RowPicture picture_of(const Arguments& arguments, const FeatureView& zones, const io::Layer& objects) {
  RowPicture picture{"zones", ""};
  if (arguments.job.picture.empty()) return picture;
  picture.classes = io::classes_by_neighbours(zones, "zones");
  if (!objects.regions.points.empty()) picture.over = {{objects.regions, "#33414e", "objects"}};
  return picture;
}

int run(const Arguments& arguments, bool json) {
  const ZonePlan plan = zone_plan(arguments.tolerance, arguments.distance, arguments.crs);
  RowJob job("zones", inputs_of(arguments), arguments.job, arguments.rows, json);
  const io::Rows& rows = job.layers().front();
  const io::Rows* const frame = job.layers().size() > 1 ? &job.layers().back() : nullptr;
  if (frame && frame->layer.regions.points.empty())
    throw io::IoError(fmt::format("--within {}: there are no polygons, so there is no frame", arguments.within));
  const Groups objects = objects_of(arguments, job);
  ResultColumns columns = columns_of(arguments, rows.table, objects);
  const PlaneChoice choice = choose_plane(plan, rows.layer, frame ? &frame->layer : nullptr);
  if (!choice.note.empty()) job.note(choice.note);
  const BufferPlane plane(rows, choice.crs_wkt);
  std::optional<BufferPlane> frame_plane;
  if (frame) frame_plane.emplace(*frame, choice.crs_wkt);
  ZoneOptions options;
  set_lengths(options, plan, plane.unit());

  ZonesReport report;
  FeatureSet zones;
  job.compute([&](const Options& common) {
    static_cast<CallOptions&>(options) = common;
    options.statistics = &report.statistics;
    const Numbered numbered(plane, objects);
    const RegionView within = frame ? frame_plane->shapes().shapes.regions : RegionView{};
    zones = plane.coverage_back(oblast::zones(numbered.features(), within, options), options);
    complete(zones, objects.size());
    count(zones, report.statistics.overlay);
    *common.statistics = report.statistics.overlay;
  });
  report.objects = objects.size();
  report.without_zone = empty_rows(zones);
  if (report.without_zone > 0)
    job.note(counted(report.without_zone, "object") +
             " without a zone: outside of all, without a geometry, or covered by objects before it");
  report.describe(plane.crs());
  job.add_to_summary(report.to_json(), true);
  const int code = job.finish(zones, std::move(columns), picture_of(arguments, zones, rows.layer));
  if (!json && !arguments.job.quiet) fmt::print(stderr, "{}", report.to_text());
  return code;
}

}  // namespace

void add_zones(CLI::App& program, Invocation& invocation) {
  const auto arguments = std::make_shared<Arguments>();
  Arguments* const a = arguments.get();
  CLI::App* command = program.add_subcommand("zones", "Divide an area by the nearest point, line or polygon.");
  command->footer(footer);
  command->add_option("IN", a->inputs, input_help)->required()->type_name("");
  command->add_option("--by", a->by, "features with the same values in these columns are one object")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("COLUMN,...");
  command->add_option("--within", a->within, "the area to divide: the polygons of a file, as IN (default: a box)")
      ->type_name("FRAME");
  command->add_option("--where-within", a->where_within, "the same as --where, for the features of --within")
      ->type_name("CONDITION");
  command
      ->add_option("--tolerance", a->tolerance,
                   "how much nearer another object may be: a length such as 0.1m, or a share of the larger side of "
                   "the box of all objects (default: 1e-5)")
      ->type_name("T");
  command
      ->add_option("--distance", a->distance,
                   "how far a zone may reach from its object: a number with a unit, or in that of the coordinates "
                   "(default: any distance)")
      ->type_name("D");
  command->add_option("--crs", a->crs, plane_help)->type_name("CRS");
  add_row_options(*command, a->rows, Select::columns);
  add_zone_file_options(*command, a->job, invocation);
  command->callback([arguments, &invocation] {
    invocation.run = [arguments, &invocation] { return run(*arguments, invocation.json); };
  });
}

}  // namespace oblast::app
