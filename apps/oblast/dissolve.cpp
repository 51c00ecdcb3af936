// `oblast dissolve`: unites the features that have the same values in some columns.
#include <fmt/format.h>
#include <oblast/features.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "oblast/aggregate.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
Features with the same values in the columns of --by become one row. Without --by, all
features become one row. Rows are sorted by these values. Features without a value (null)
become a row of their own, at the end.

Without --agg the other columns keep the first value of the group that is not null. With
--agg only the columns that it names are kept. If it names a column several times, the
function is added to the name, as in people_min.

Example: the area and the number of inhabitants of each region
  oblast dissolve communes.gpkg -o regions.gpkg --by region --agg people:sum --area m2)";

struct Arguments {
  std::vector<std::string> inputs, by;
  std::vector<Aggregate> aggregates;
  JobArguments job;
  RowArguments rows;
};

std::size_t column_of(const std::string& name, const std::vector<io::Rows>& layers) {
  check_column(name, layers);
  return *layers.front().table.find(name);
}

std::vector<Aggregate> all_first(const io::AttributeTable& table, const Arguments& arguments) {
  std::vector<Aggregate> aggregates;
  for (const std::size_t c : selected(table, arguments.rows.select)) {
    const std::string& name = table.columns()[c].name;
    if (std::find(arguments.by.begin(), arguments.by.end(), name) == arguments.by.end())
      aggregates.push_back({name, Aggregation::first});
  }
  return aggregates;
}

int run(const Arguments& arguments, bool json) {
  if (!arguments.aggregates.empty() && !arguments.rows.select.empty())
    throw CallError("--agg names the columns that are kept; leave out --select");
  RowJob job("dissolve", {{"input", arguments.inputs}}, arguments.job, arguments.rows, json);
  const io::Rows& layer = job.layers().front();
  std::vector<std::size_t> by;
  for (const std::string& name : arguments.by) by.push_back(column_of(name, job.layers()));
  const Groups groups = group_rows(layer.table, by);

  ResultColumns columns;
  for (const std::size_t c : by) {
    auto& rows = columns.indices.emplace_back();
    for (const auto& group : groups.rows) rows.push_back(group.front());
    columns.join(layer.table, c, rows);
  }
  const std::vector<Aggregate> aggregates =
      arguments.aggregates.empty() ? all_first(layer.table, arguments) : arguments.aggregates;
  for (const Aggregate& aggregate : aggregates) {
    const bool again = std::count_if(aggregates.begin(), aggregates.end(),
                                     [&](const Aggregate& other) { return other.column == aggregate.column; }) > 1 ||
                       std::find(arguments.by.begin(), arguments.by.end(), aggregate.column) != arguments.by.end();
    add_aggregate(layer.table, column_of(aggregate.column, job.layers()), aggregate.function,
                  again ? aggregate.column + "_" + name(aggregate.function) : aggregate.column, groups, columns);
  }

  FeatureSet result;
  job.compute([&](const Options& options) { result = dissolve(layer.view(), groups.group_of_row, options); });
  return job.finish(result, std::move(columns), {"dissolve", arguments.by.empty() ? "" : arguments.by.front()});
}

}  // namespace

void add_dissolve(CLI::App& program, Invocation& invocation) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("dissolve", "Unite the features that have the same attributes.");
  command->footer(footer);
  command->add_option("IN", arguments->inputs, input_help)->required()->type_name("");
  command->add_option("--by", arguments->by, "the columns whose values make the groups (default: one group)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("COLUMN,...");
  command
      ->add_option_function<std::vector<std::string>>(
          "--agg",
          [arguments](const std::vector<std::string>& words) {
            for (const std::string& word : words) arguments->aggregates.push_back(parse_aggregate(word));
          },
          "what becomes of a column: first, last, sum, mean, min, max, count or list; may be given several times")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("COLUMN:FUNCTION,...");
  add_row_options(*command, arguments->rows, Select::columns);
  add_file_options(*command, arguments->job, invocation);
  command->callback([arguments, &invocation] {
    invocation.run = [arguments, &invocation] { return run(*arguments, invocation.json); };
  });
}

}  // namespace oblast::app
