// `oblast partition`: cuts the plane by all features of all layers.
#include <fmt/format.h>
#include <oblast/features.h>

#include <CLI/CLI.hpp>

#include "oblast/file_names.h"
#include "oblast/row_job.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
A row for every set of features that cover a place. Rows do not overlap. The column
`sources` has the features as FILE:ID, separated by semicolons, and `count` their number.
FILE is the name without folder and extension, or the whole path if two files share the
name. ID is the feature id that GDAL shows.

Example: which sensors saw each part of a fire
  oblast partition modis.shp viirs.shp hotspots.gpkg -o seen.gpkg)";

struct Arguments {
  std::vector<std::string> inputs;
  JobArguments job;
  RowArguments rows;
};

void add_sources(const Partition& result, const std::vector<io::Rows>& layers, ResultColumns& columns) {
  const auto names = file_names(layers);
  std::vector<io::Value> sources, counts;
  for (std::size_t row = 0; row < result.rows.size(); ++row) {
    std::string text;
    for (const FeatureSource& source : result.sources_of(row)) {
      const io::FeatureRange& feature = layers[source.layer].layer.features[source.feature];
      text += fmt::format("{}{}:{}", text.empty() ? "" : ";", names[source.layer][feature.file], feature.feature);
    }
    sources.emplace_back(std::move(text));
    counts.emplace_back(static_cast<std::int64_t>(result.sources_of(row).size()));
  }
  columns.add("sources", io::ColumnType::text, std::move(sources));
  columns.add("count", io::ColumnType::integer, std::move(counts));
}

int run(const Arguments& arguments, bool json) {
  std::vector<RowInput> inputs;
  for (const std::string& path : arguments.inputs) inputs.push_back({path, {path}});
  RowJob job("partition", inputs, arguments.job, arguments.rows, json);
  std::vector<FeatureView> views;
  for (const io::Rows& layer : job.layers()) views.push_back(layer.view());
  Partition result;
  job.compute([&](const Options& options) { result = partition(views, options); });
  ResultColumns columns;
  add_sources(result, job.layers(), columns);
  return job.finish(result.rows, std::move(columns), {"partition", "count"});
}

}  // namespace

void add_partition(CLI::App& program, Invocation& invocation) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      program.add_subcommand("partition", "Cut the plane by all features, and name those of each part.");
  command->footer(footer);
  command->add_option("IN", arguments->inputs, input_help)->required()->type_name("");
  add_row_options(*command, arguments->rows, Select::none);
  add_file_options(*command, arguments->job, invocation);
  command->callback([arguments, &invocation] {
    invocation.run = [arguments, &invocation] { return run(*arguments, invocation.json); };
  });
}

}  // namespace oblast::app
