// Options of writing; see outputs.h.
#include "oblast/outputs.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

namespace oblast::app {

namespace {

io::TextFormat parse_format(const std::string& word) {
  if (word == "wkt") return io::TextFormat::wkt;
  if (word == "wkb") return io::TextFormat::wkb;
  if (word == "geojson") return io::TextFormat::geojson;
  throw CLI::ValidationError(
      fmt::format("'{}' is not a format of standard output; choose from wkt, wkb, geojson", word));
}

}  // namespace

void add_output_options(CLI::App& command, OutputArguments& arguments, Invocation& invocation) {
  OutputArguments* const a = &arguments;
  command
      .add_option_function<std::string>(
          "-o,--output",
          [a, &invocation](const std::string& word) {
            a->output = word;
            invocation.output = word;
          },
          "file for the result, FILE.gpkg:LAYER for a layer of a GeoPackage, or `-`: standard output")
      ->required()
      ->type_name("OUT");
  command
      .add_option_function<std::string>(
          "--format", [a](const std::string& word) { a->format = parse_format(word); },
          "with `-o -`: wkt (default), wkb or geojson")
      ->type_name("FORMAT");
  command.add_flag("--overwrite", a->overwrite, "replace existing files (of a GeoPackage: the layer that is written)");
}

io::WriteOptions write_options(const OutputArguments& arguments) {
  if (arguments.format && arguments.output != "-")
    throw CallError("--format is for `-o -`; the extension of a file decides its format");
  io::WriteOptions options;
  options.existing = arguments.overwrite ? io::Existing::overwrite : io::Existing::refuse;
  options.standard_output = arguments.format.value_or(io::TextFormat::wkt);
  return options;
}

void print_json(const nlohmann::ordered_json& report, const std::string& output) {
  fmt::print(output == "-" ? stderr : stdout, "{}\n",
             report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

}  // namespace oblast::app
