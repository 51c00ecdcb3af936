// `oblast union`: unites all polygons of all files. With --source the result is cut by the files that cover it.
#include <fmt/format.h>
#include <oblast/features.h>

#include <CLI/CLI.hpp>

#include "oblast/file_names.h"
#include "oblast/job.h"
#include "oblast/names.h"
#include "oblast/row_job.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
Each polygon of each file is filled by even-odd of its own rings. The result is the area
that at least one polygon covers. With `--fill atleast:3` it is the area that at least
three polygons cover. The rules evenodd, nonzero, positive and negative use the winding
number of all contours together.

With --source the result is a row for every set of files that cover a place, with the names
of the files, separated by semicolons, in the column.

Example: one clean layer from a folder of shapefiles, with a picture
  oblast union fires/ -o burnt.gpkg --svg burnt.svg)";

struct Arguments {
  std::vector<std::string> inputs;
  std::string source;  // name of the column; empty: none
  JobArguments job;
};

// All polygons of a file are one feature.
std::vector<std::uint32_t> ends_of_files(const io::Layer& layer) {
  const auto polygons = static_cast<std::uint32_t>(RegionView(layer.regions).polygon_count());
  std::vector<std::uint32_t> ends(layer.files.size(), polygons);
  for (std::size_t f = layer.features.size(); f-- > 0;) {
    for (std::uint32_t file = layer.features[f].file; file-- > 0 && ends[file] > layer.features[f].first_polygon;)
      ends[file] = layer.features[f].first_polygon;
  }
  return ends;
}

int run_with_sources(const Arguments& arguments, bool json) {
  if (arguments.job.options.engine != Engine::leonov_nikitin)
    throw CallError(fmt::format("there is one engine for rows; leave out --source to use --engine {}",
                                name(arguments.job.options.engine)));
  RowJob job("union", {{"input", arguments.inputs}}, arguments.job, {}, json);
  const io::Layer& layer = job.layers().front().layer;
  const std::vector<std::uint32_t> ends = ends_of_files(layer);
  const FeatureView files[] = {{layer.regions, ends}};
  Partition result;
  job.compute([&](const Options& options) { result = partition(files, options); });

  const std::vector<std::string> names = file_names(job.layers()).front();
  std::vector<io::Value> sources;
  for (std::size_t row = 0; row < result.rows.size(); ++row) {
    std::string text;
    for (const FeatureSource& source : result.sources_of(row))
      text += (text.empty() ? "" : ";") + names[source.feature];
    sources.emplace_back(std::move(text));
  }
  ResultColumns columns;
  columns.add(arguments.source, io::ColumnType::text, std::move(sources));
  return job.finish(result.rows, std::move(columns), {"union", {}});
}

}  // namespace

void add_union(CLI::App& program, Invocation& invocation) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("union", "Unite all polygons of all files in one pass.");
  command->footer(footer);
  command->add_option("IN", arguments->inputs, input_help)->required()->type_name("");
  command
      ->add_option("--source", arguments->source, "cut the result by file, and add a column with the files of each row")
      ->type_name("COLUMN");
  add_job_options(*command, arguments->job, invocation, Operands::one);
  command->callback([arguments, &invocation] {
    invocation.run = [arguments, &invocation] {
      if (!arguments->source.empty()) return run_with_sources(*arguments, invocation.json);
      const Job job{"union", {arguments->inputs}, Operation::unite};
      return run_job(job, arguments->job, invocation.json);
    };
  });
}

}  // namespace oblast::app
