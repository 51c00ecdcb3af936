// `oblast layers`: Tables 1 and 3 of the 2013 paper for groups of files: the size of the input, the number of layers of
// disjoint contours, and the size of the union.
#include <fmt/format.h>
#include <oblast/layers.h>
#include <oblast/oblast.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "io/read.h"
#include "oblast/call_options.h"
#include "oblast/command.h"
#include "oblast/console.h"
#include "oblast/inputs.h"
#include "oblast/names.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
A layer is a set of contours of which no two overlap. Each contour, in the order of the
files, goes into the first layer in which nothing overlaps it. Each IN is a group. With
--prefix N, files whose names begin with the same N characters are a group.

Example: the months of `oblast generate fires -o fires` (fires-2011-04-..., ...)
  oblast layers fires --prefix 13)";

struct Arguments {
  InputArguments input;
  std::vector<std::string> inputs;
  std::size_t prefix = 0;
  Options options;
  LayerRule rule = LayerRule::interiors;
};

struct Group {
  std::size_t files = 0;
  RegionSet contours;
};

struct Row {
  std::string name;
  std::size_t files, contours, vertices;
  std::uint32_t layers;
  std::size_t result_contours, result_vertices;
  double layers_seconds, union_seconds;
};

/// Appends the polygons [begin, end).
void append(RegionSet& to, const RegionView& from, std::size_t begin, std::size_t end) {
  for (std::size_t p = begin; p < end; ++p) {
    for (std::uint32_t c = from.polygon_begin(p); c < from.polygon_end(p); ++c) {
      const auto contour = from.contour(c);
      to.points.insert(to.points.end(), contour.begin(), contour.end());
      to.contour_ends.push_back(static_cast<std::uint32_t>(to.points.size()));
    }
    to.polygon_ends.push_back(static_cast<std::uint32_t>(to.contour_ends.size()));
  }
}

/// Groups the files by the first `length` characters of their names, sorted by these.
std::map<std::string, Group> groups_by_prefix(const io::Layer& layer, std::size_t length) {
  std::map<std::string, Group> groups;
  std::vector<Group*> group_of_file;
  for (const std::string& file : layer.files) {
    const std::string name = std::filesystem::path(file).filename().string();
    Group& group = groups[name.substr(0, length)];
    ++group.files;
    group_of_file.push_back(&group);
  }
  const RegionView regions = layer.regions;
  for (std::size_t f = 0; f < layer.features.size(); ++f) {
    const std::size_t end =
        f + 1 < layer.features.size() ? layer.features[f + 1].first_polygon : regions.polygon_count();
    append(group_of_file[layer.features[f].file]->contours, regions, layer.features[f].first_polygon, end);
  }
  return groups;
}

Row measure(const std::string& name, const Group& group, const Arguments& arguments) {
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point t) { return std::chrono::duration<double>(Clock::now() - t).count(); };
  Row row{name, group.files, group.contours.contour_ends.size(), group.contours.points.size(), 0, 0, 0, 0, 0};
  auto begin = Clock::now();
  row.layers = layers(group.contours, arguments.rule, arguments.options).count;
  row.layers_seconds = since(begin);
  begin = Clock::now();
  const RegionSet result = unite(group.contours, arguments.options);
  row.union_seconds = since(begin);
  row.result_contours = result.contour_ends.size();
  row.result_vertices = result.points.size();
  return row;
}

void print(const std::vector<Row>& rows) {
  std::size_t width = 5;
  for (const Row& row : rows) width = std::max(width, row.name.size());
  fmt::print("{:<{}} {:>6} {:>9} {:>10} {:>7} {:>9} {:>10} {:>9} {:>9}\n", "group", width, "files", "contours",
             "vertices", "layers", "result", "vertices", "layers, s", "union, s");
  for (const Row& row : rows)
    fmt::print("{:<{}} {:>6} {:>9} {:>10} {:>7} {:>9} {:>10} {:>9.3f} {:>9.3f}\n", row.name, width, grouped(row.files),
               grouped(row.contours), grouped(row.vertices), grouped(row.layers), grouped(row.result_contours),
               grouped(row.result_vertices), row.layers_seconds, row.union_seconds);
}

void print_json(const std::vector<Row>& rows) {
  nlohmann::ordered_json groups = nlohmann::ordered_json::array();
  for (const Row& row : rows)
    groups.push_back({{"group", row.name},
                      {"files", row.files},
                      {"contours", row.contours},
                      {"vertices", row.vertices},
                      {"layers", row.layers},
                      {"result_contours", row.result_contours},
                      {"result_vertices", row.result_vertices},
                      {"layers_seconds", row.layers_seconds},
                      {"union_seconds", row.union_seconds}});
  const nlohmann::ordered_json object{{"command", "layers"}, {"groups", groups}};
  fmt::print("{}\n", object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

int run(const Arguments& arguments, bool json) {
  std::vector<Row> rows;
  Group all;
  const auto add = [&](const std::string& name, const Group& group) {
    rows.push_back(measure(name, group, arguments));
    all.files += group.files;
  };
  if (arguments.prefix > 0) {
    io::Layer layer = io::read(arguments.inputs, read_options(arguments.input, {}));
    print_notes(reading_notes("input", layer));
    for (const auto& [name, group] : groups_by_prefix(layer, arguments.prefix)) add(name, group);
    all.contours = std::move(layer.regions);
  } else {
    for (const std::string& input : arguments.inputs) {
      io::Layer layer = io::read(std::span(&input, 1), read_options(arguments.input, {}));
      print_notes(reading_notes(input, layer));
      const RegionView regions = layer.regions;
      append(all.contours, regions, 0, regions.polygon_count());
      add(input, {layer.files.size(), std::move(layer.regions)});
    }
  }
  if (rows.size() > 1) rows.push_back(measure("all", all, arguments));
  if (json)
    print_json(rows);
  else
    print(rows);
  return exit_done;
}

}  // namespace

void add_layers(CLI::App& program, Invocation& invocation) {
  const auto a = std::make_shared<Arguments>();
  a->options.engine = Engine::vatti;  // the paper's
  CLI::App* command =
      program.add_subcommand("layers", "Count layers of disjoint contours, and unite, by groups of files.");
  command->footer(footer);
  command->add_option("IN", a->inputs, input_help)->required()->type_name("");
  command->add_option("--prefix", a->prefix, "group the files by the first N characters of their names")
      ->check(CLI::Validator(CLI::PositiveNumber).description(""))
      ->type_name("N");
  command->add_flag_callback(
      "--boxes", [a] { a->rule = LayerRule::boxes; },
      "separate contours whose boxes overlap, as in the paper; this makes more layers");
  command
      ->add_option_function<std::string>(
          "--engine", [a](const std::string& word) { a->options.engine = parse_engine(word); },
          "the engine of the union: vatti (default, as in the paper), leonov-nikitin or skvortsov")
      ->type_name("ENGINE");
  add_input_options(*command, a->input);
  add_call_options(*command, a->options);
  command->add_flag("--json", invocation.json, "print one JSON object on standard output instead of the table");
  command->callback([a, &invocation] { invocation.run = [a, &invocation] { return run(*a, invocation.json); }; });
}

}  // namespace oblast::app
