// `oblast depth`: how many features cover a place.
#include <oblast/features.h>

#include <CLI/CLI.hpp>

#include "oblast/groups.h"
#include "oblast/row_job.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
The row with `depth` = d is where exactly d features lie over each other, d from 1 on.
With --by, d is the number of different values that these features have in the column.
Null counts as a value.

Example: on how many days each place burnt
  oblast depth fires/ -o days.gpkg --by day --area m2)";

struct Arguments {
  std::vector<std::string> inputs, by;
  JobArguments job;
  RowArguments rows;
};

int run(const Arguments& arguments, bool json) {
  RowJob job("depth", {{"input", arguments.inputs}}, arguments.job, arguments.rows, json);
  const io::Rows& layer = job.layers().front();
  std::vector<std::size_t> by;
  for (const std::string& name : arguments.by) {
    check_column(name, job.layers());
    by.push_back(*layer.table.find(name));
  }
  std::vector<std::uint32_t> groups;
  if (!by.empty()) groups = group_rows(layer.table, by).group_of_row;

  FeatureSet result;
  job.compute([&](const Options& options) { result = depth(layer.view(), groups, options); });
  std::vector<io::Value> depths;
  for (const FeatureKey& key : result.keys) depths.emplace_back(static_cast<std::int64_t>(key.a));
  ResultColumns columns;
  columns.add("depth", io::ColumnType::integer, std::move(depths));
  return job.finish(result, std::move(columns), {"depth", "depth"});
}

}  // namespace

void add_depth(CLI::App& program, Invocation& invocation) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("depth", "Count the features that cover each place.");
  command->footer(footer);
  command->add_option("IN", arguments->inputs, input_help)->required()->type_name("");
  command->add_option("--by", arguments->by, "count different values of these columns, not features")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("COLUMN,...");
  add_row_options(*command, arguments->rows, Select::none);
  add_file_options(*command, arguments->job, invocation);
  command->callback([arguments, &invocation] {
    invocation.run = [arguments, &invocation] { return run(*arguments, invocation.json); };
  });
}

}  // namespace oblast::app
