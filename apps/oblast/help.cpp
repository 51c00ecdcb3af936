// `oblast help`: the help of the program, of a command, and the recipes.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "oblast/command.h"
#include "oblast/recipes.h"
#include "oblast/suggestion.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
Examples
  oblast help
  oblast help clip
  oblast help recipes)";

const CLI::App* inner_command(const CLI::App& command, const std::string& word) {
  for (const CLI::App* inner : command.get_subcommands({}))
    if (inner->get_name() == word) return inner;
  return nullptr;
}

std::string help_of(const CLI::App& program, const std::vector<std::string>& words) {
  if (words.size() == 1 && words.front() == "recipes") return recipes;
  const CLI::App* command = &program;
  std::string above;
  for (const std::string& word : words) {
    const CLI::App* const inner = inner_command(*command, word);
    if (!inner) {
      const std::string meant = command == &program ? suggested_command(program, word) : "";
      throw CallError(fmt::format("there is no help for '{}'{}; `oblast help` lists the commands", word,
                                  meant.empty() ? "" : fmt::format(", did you mean `{}`?", meant)));
    }
    above += (above.empty() ? "" : " ") + command->get_name();
    command = inner;
  }
  return command->help(above);
}

}  // namespace

void add_help(CLI::App& program, Invocation& invocation) {
  const auto words = std::make_shared<std::vector<std::string>>();
  CLI::App* command = program.add_subcommand("help", "Show the help of a command, or the recipes.");
  command->footer(footer);
  command->add_option("COMMAND", *words, "a command, or the word recipes; without it: all commands")->type_name("");
  command->callback([words, &program, &invocation] {
    invocation.run = [words, &program] {
      // A selected subcommand would show its own help in place of that of the program.
      const std::vector<std::string> wanted = std::exchange(*words, {});
      program.clear();
      fmt::print("{}", help_of(program, wanted));
      return exit_done;
    };
  });
}

}  // namespace oblast::app
