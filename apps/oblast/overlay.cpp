// `oblast overlay`: intersection, union, difference, symmetric difference or identity of two layers, with attributes;
// or, with --merge, of two operands as single regions.
#include <fmt/format.h>
#include <oblast/features.h>

#include <CLI/CLI.hpp>

#include "oblast/job.h"
#include "oblast/names.h"
#include "oblast/row_job.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
OP is intersection, union, difference (A without B), symdifference (the part that is in
exactly one of A and B) or identity (A, cut by B). The polygons of a layer may overlap
each other and themselves.

Each pair of a feature of A and a feature of B that overlap gives a row with the columns
of both. The parts of A outside B (of B outside A) are rows with nulls in the columns of
B (of A), if OP has them. The rows of difference have the columns of A only. Columns of
the same name get _1 in A and _2 in B. Neighbouring rows share their borders bit for bit.

--merge leaves the attributes out: A and B are two regions, and so is the result. Then
one feature is written for each polygon.

Examples: the area that burnt in June but not in May; which commune each fire burnt
  oblast overlay difference june.gpkg may.gpkg -o new.gpkg --merge
  oblast overlay intersection fires.shp communes.gpkg -o burnt.gpkg --area m2)";

struct Arguments {
  std::string operation, a, b;
  FeatureOperation parsed = FeatureOperation::unite;
  bool merge = false;
  JobArguments job;
  RowArguments rows;
};

// All rows of the result are (i, j); columns of A are joined by i, those of B by j. `layer_count` is 1 if no row has a
// feature of B.
void join_columns(const std::vector<io::Rows>& layers, std::size_t layer_count, const FeatureSet& result,
                  const std::vector<std::string>& select, ResultColumns& columns) {
  auto& rows_a = columns.indices.emplace_back();
  auto& rows_b = columns.indices.emplace_back();
  for (const FeatureKey& key : result.keys) {
    rows_a.push_back(key.a);
    rows_b.push_back(key.b);
  }
  const std::span<const std::uint32_t> rows[] = {rows_a, rows_b};
  for (std::size_t k = 0; k < layer_count; ++k) {
    const io::AttributeTable& table = layers[k].table;
    const io::AttributeTable& other = layers[1 - k].table;
    for (const std::size_t c : selected(table, select)) {
      columns.join(table, c, rows[k]);
      std::string& name = columns.columns.back().column.name;
      if (layer_count > 1 && other.find(name)) name += k == 0 ? "_1" : "_2";
    }
  }
}

int overlay_rows(const Arguments& arguments, bool json) {
  const std::string operation = name(arguments.parsed);
  RowJob job("overlay " + operation,
             {{"A", {arguments.a}, arguments.rows.where_a}, {"B", {arguments.b}, arguments.rows.where_b}},
             arguments.job, arguments.rows, json);
  const auto& layers = job.layers();
  FeatureSet result;
  job.compute([&](const Options& options) {
    result = overlay_features(layers[0].view(), layers[1].view(), arguments.parsed, options);
  });
  ResultColumns columns;
  const std::size_t layer_count = arguments.parsed == FeatureOperation::difference ? 1 : 2;
  join_columns(layers, layer_count, result, arguments.rows.select, columns);
  return job.finish(result, std::move(columns), {operation, {}});
}

int run(const Arguments& arguments, bool json) {
  if (arguments.merge) {
    const RowArguments& rows = arguments.rows;
    if (!rows.where.empty() || rows.where_a || rows.where_b || !rows.select.empty() || !rows.area.empty() ||
        !rows.perimeter.empty())
      throw CallError("--where, --select, --area and --perimeter are for rows; leave out --merge");
    const std::optional<Operation> merged = merged_operation(arguments.parsed);
    if (!merged) throw CallError("identity with --merge is A itself; use `oblast union A`, or leave out --merge");
    const Job job{"overlay " + name(*merged), {{arguments.a}, {arguments.b}}, *merged};
    return run_job(job, arguments.job, json);
  }
  if (arguments.job.options.engine != Engine::leonov_nikitin)
    throw CallError(fmt::format("there is one engine for rows; add --merge to use --engine {}",
                                name(arguments.job.options.engine)));
  return overlay_rows(arguments, json);
}

}  // namespace

void add_overlay(CLI::App& program, Invocation& invocation) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("overlay", "Overlay two layers, with their attributes.");
  command->footer(footer);
  command
      ->add_option_function<std::string>(
          "OP", [arguments](const std::string& word) { arguments->parsed = parse_feature_operation(word); },
          "the operation: intersection, union, difference, symdifference or identity")
      ->required()
      ->type_name("");
  command->add_option("A", arguments->a, input_help)->required()->type_name("");
  command->add_option("B", arguments->b, "the second layer, as A")->required()->type_name("");
  command->add_flag("--merge", arguments->merge,
                    "one region, without attributes (needed for --engine and some --fill)");
  add_row_options(*command, arguments->rows, Select::columns);
  command->add_option("--where-a", arguments->rows.where_a, "the condition for A, if it is not that for B")
      ->type_name("CONDITION");
  command->add_option("--where-b", arguments->rows.where_b, "the condition for B, if it is not that for A")
      ->type_name("CONDITION");
  add_job_options(*command, arguments->job, invocation, Operands::two);
  command->callback([arguments, &invocation] {
    invocation.run = [arguments, &invocation] { return run(*arguments, invocation.json); };
  });
}

}  // namespace oblast::app
