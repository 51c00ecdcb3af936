// `oblast overlay`: intersection, union, difference or symmetric difference of two operands.
#include "oblast/job.h"
#include "oblast/names.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
OP is intersection, union, difference (A without B) or symdifference (the part that is
in exactly one of A and B). The polygons of an operand may overlap each other and
themselves.

Example: the area that burnt in June but not in May
  oblast overlay difference june.gpkg may.gpkg -o new.gpkg)";

}  // namespace

void add_overlay(CLI::App& program, Invocation& invocation) {
  struct Arguments {
    std::string operation, a, b;
    Operation parsed = Operation::unite;
    JobArguments job;
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("overlay", "Overlay two operands.");
  command->footer(footer);
  command
      ->add_option_function<std::string>(
          "OP", [arguments](const std::string& word) { arguments->parsed = parse_operation(word); },
          "the operation: intersection, union, difference or symdifference")
      ->required()
      ->type_name("");
  command->add_option("A", arguments->a, "a vector file, a folder, or `-` for WKT on standard input")
      ->required()
      ->type_name("");
  command->add_option("B", arguments->b, "the second operand, as A")->required()->type_name("");
  add_job_options(*command, arguments->job, invocation, Operands::two);
  command->callback([arguments, &invocation] {
    invocation.run = [arguments, &invocation] {
      const Job job{"overlay " + name(arguments->parsed), {{arguments->a}, {arguments->b}}, arguments->parsed};
      return run_job(job, arguments->job, invocation.json);
    };
  });
}

}  // namespace oblast::app
