// `oblast compare`: runs every method on one pair of operands.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "io/picture_file.h"
#include "oblast/call_options.h"
#include "oblast/command.h"
#include "oblast/comparison.h"
#include "oblast/inputs.h"
#include "oblast/names.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
Runs the three engines and the four classic methods. Prints for each what Skvortsov's
Table 1 states, whether it accepts this input (and if not, why), the shortest time of a
few runs, and whether its result has the same bytes as that of the default engine. The
exit code is 1 if the bytes of any method differ.

Example
  oblast compare districts.gpkg window.gpkg --op intersection --svg compare.svg)";

struct Arguments {
  std::string a, b, picture;
  Operation operation = Operation::intersection;
  InputArguments input;
  bool overwrite = false;
  CallOptions options;
};

int run(const Arguments& arguments, bool json) {
  if (arguments.a == "-" && arguments.b == "-") throw CallError("standard input (-) can be named only once");
  const io::Existing existing = arguments.overwrite ? io::Existing::overwrite : io::Existing::refuse;
  if (arguments.picture == "-") throw CallError("the table is on standard output; give --svg a file");
  if (!arguments.picture.empty()) io::check_picture_writable(arguments.picture, existing);
  const OperandPair pair = read_pair(arguments.a, arguments.b, read_options(arguments.input, {}));
  print_notes(notes_of(pair));
  const std::vector<Row> rows = compare_methods(pair, arguments.operation, arguments.options);
  if (!arguments.picture.empty()) io::write_picture(arguments.picture, draw(rows, pair, arguments.operation), existing);
  if (json) {
    const nlohmann::ordered_json object{{"command", "compare"},
                                        {"operation", name(arguments.operation)},
                                        {"vertices_a", pair.a.regions.points.size()},
                                        {"vertices_b", pair.b.regions.points.size()},
                                        {"methods", to_json(rows)}};
    fmt::print("{}\n", object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else {
    fmt::print("{}", to_text(rows));
  }
  for (const Row& row : rows)
    if (row.admitted && !row.same_bytes) return exit_data;
  return exit_done;
}

}  // namespace

void add_compare(CLI::App& program, Invocation& invocation) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("compare", "Run every method on one pair of operands, and compare.");
  command->footer(footer);
  command->add_option("A", a->a, input_help)->required()->type_name("");
  command->add_option("B", a->b, "the second operand, as A")->required()->type_name("");
  command
      ->add_option_function<std::string>(
          "--op", [a](const std::string& word) { a->operation = parse_operation(word); },
          "the operation: intersection (default), union, difference or symdifference")
      ->type_name("OP");
  add_input_options(*command, a->input);
  add_call_options(*command, a->options);
  command->add_option("--svg,--picture", a->picture, "also draw a picture (.svg or .png) with one panel per method")
      ->type_name("PICTURE");
  command->add_flag("--overwrite", a->overwrite, "replace an existing picture");
  command->add_flag("--json", invocation.json, "print one JSON object on standard output instead of the table");
  command->callback([a, &invocation] { invocation.run = [a, &invocation] { return run(*a, invocation.json); }; });
}

}  // namespace oblast::app
