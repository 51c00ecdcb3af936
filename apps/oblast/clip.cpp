// `oblast clip` and `oblast erase`: the part of a layer inside, or outside, another one. The other layer enters as one
// feature, so its rows divide nothing, however they overlap.
#include <oblast/features.h>

#include <CLI/CLI.hpp>

#include "oblast/row_job.h"

namespace oblast::app {

namespace {

constexpr const char* clip_footer = R"(
Each feature of IN keeps its part inside WINDOW, and its attributes. Features that have no
part there are left out. The polygons of WINDOW count as one area: they may overlap, and
their attributes are not used. Features that shared a border before share it afterwards.

`oblast overlay intersection` cuts by each feature of the second layer instead, and adds
its columns.

Example: the forests of one region, and how large they are there
  oblast clip forests.gpkg regions.gpkg --where-window "name = 'Picardie'" -o out.gpkg --area m2)";

constexpr const char* erase_footer = R"(
Each feature of IN keeps its part outside MASK, and its attributes. Features that have no
part there are left out. The polygons of MASK count as one area: they may overlap, and
their attributes are not used. Features that shared a border before share it afterwards.

Example: the fields without the flooded area, and how large they are now
  oblast erase fields.gpkg flood.gpkg -o dry.gpkg --area m2)";

struct Arguments {
  std::string in, other, where_other;
  JobArguments job;
  RowArguments rows;
};

struct Command {
  const char* word;
  const char* other;  // the name of the second positional
  const char* where_other;
  FeatureOperation operation;
};
constexpr Command clip{"clip", "WINDOW", "--where-window", FeatureOperation::intersection};
constexpr Command erase{"erase", "MASK", "--where-mask", FeatureOperation::difference};

int run(const Command& command, const Arguments& arguments, bool json) {
  RowJob job(command.word, {{"IN", {arguments.in}}, {command.other, {arguments.other}, arguments.where_other}},
             arguments.job, arguments.rows, json);
  const io::Rows& in = job.layers()[0];
  for (const std::string& column : arguments.rows.select) check_column(column, {&in, 1});
  const RegionView regions = job.layers()[1].layer.regions;
  const std::uint32_t one_feature[] = {static_cast<std::uint32_t>(regions.polygon_count())};
  FeatureSet result;
  job.compute([&](const Options& options) {
    result = overlay_features(in.view(), {regions, one_feature}, command.operation, options);
  });
  ResultColumns columns;
  auto& rows = columns.indices.emplace_back();
  for (const FeatureKey& key : result.keys) rows.push_back(key.a);
  for (const std::size_t c : selected(in.table, arguments.rows.select)) columns.join(in.table, c, rows);
  return job.finish(result, std::move(columns), {command.word, {}});
}

void add(CLI::App& program, Invocation& invocation, const Command& command, const char* what, const char* footer) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* added = program.add_subcommand(command.word, what);
  added->footer(footer);
  added->add_option("IN", arguments->in, input_help)->required()->type_name("");
  const std::string other = command.other;
  added->add_option(other, arguments->other, "the other layer, as IN")->required()->type_name("");
  add_row_options(*added, arguments->rows, Select::columns);
  added->add_option(command.where_other, arguments->where_other, "the same for the features of " + other)
      ->type_name("CONDITION");
  add_file_options(*added, arguments->job, invocation);
  added->callback([arguments, &command, &invocation] {
    invocation.run = [arguments, &command, &invocation] { return run(command, *arguments, invocation.json); };
  });
}

}  // namespace

void add_clip(CLI::App& program, Invocation& invocation) {
  add(program, invocation, clip, "Keep the part of a layer inside another one, with its attributes.", clip_footer);
}

void add_erase(CLI::App& program, Invocation& invocation) {
  add(program, invocation, erase, "Keep the part of a layer outside another one, with its attributes.", erase_footer);
}

}  // namespace oblast::app
