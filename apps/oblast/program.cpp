// Reads the command line and reports the errors of every command. Each command has a file of its own.
#include "oblast/program.h"

#include <fmt/format.h>
#include <oblast/error.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <new>
#include <nlohmann/json.hpp>

#include "io/layer.h"
#include "oblast/command.h"
#include "oblast/help_format.h"
#include "oblast/interrupt.h"
#include "oblast/suggestion.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(`oblast help COMMAND` describes a command and gives an example. `oblast help recipes`
shows the commands for common tasks.

Exit codes: 0 success, 1 an error in the data, 2 an error in the command line (also an
input that cannot be opened), 130 interrupted.)";

int fail(const Invocation& invocation, int code, const std::string& message) {
  const bool piped = invocation.output == "-";
  if (!invocation.json || !piped) fmt::print(stderr, "oblast: {}\n", message);
  if (invocation.json) {
    const nlohmann::ordered_json object{{"error", message}, {"exit_code", code}};
    fmt::print(piped ? stderr : stdout, "{}\n",
               object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  }
  return code;
}

// The innermost command on the command line, for messages: "oblast generate fires".
const CLI::App* named_command(const CLI::App* app) {
  while (!app->get_subcommands().empty()) app = app->get_subcommands().front();
  return app;
}

std::string full_name(const CLI::App* app) {
  const CLI::App* parent = app->get_parent();
  return parent ? full_name(parent) + " " + app->get_name() : "oblast";
}

// CLI11 reports a request for help or for the version as an error, too; anything else is an error in the command line.
int after_parse(const CLI::App& program, const CLI::ParseError& error) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
    program.exit(error);
    return exit_done;
  }
  const CLI::App* command = named_command(&program);
  fmt::print(stderr, "{}: {}\n", full_name(command), error.what());
  for (const std::string& word : program.remaining(true)) {
    if (const std::string meant = suggested_option(*command, word); !meant.empty())
      fmt::print(stderr, "Did you mean {}?\n", meant);
  }
  fmt::print(stderr, "Try `{} --help`.\n", full_name(command));
  return exit_call;
}

// A word in place of a command that is none.
int refuse_command(const CLI::App& program, const std::string& word) {
  const std::string meant = suggested_command(program, word);
  fmt::print(stderr, "oblast: there is no command '{}'\n", word);
  if (!meant.empty()) fmt::print(stderr, "Did you mean `{}`?\n", meant);
  fmt::print(stderr, "`oblast --help` lists the commands.\n");
  return exit_call;
}

bool is_command(const CLI::App& program, const std::string& word) {
  for (const CLI::App* command : program.get_subcommands({}))
    if (command->get_name() == word) return true;
  return false;
}

int run_command(const Invocation& invocation) {
  try {
    return invocation.run();
  } catch (const CallError& error) {
    return fail(invocation, exit_call, error.what());
  } catch (const io::CannotOpen& error) {
    return fail(invocation, exit_call, error.what());
  } catch (const Interrupted&) {
    return fail(invocation, exit_interrupted, "interrupted; unfinished output was removed");
  } catch (const std::bad_alloc&) {
    return fail(invocation, exit_data,
                "out of memory: the system has no more memory for this input; unfinished output was removed");
  } catch (const Error& error) {
    return fail(invocation, error.code() == ErrorCode::bad_option ? exit_call : exit_data, error.what());
  } catch (const std::exception& error) {
    return fail(invocation, exit_data, error.what());
  }
}

}  // namespace

int run_program(int argc, char** argv) {
  install_interrupt_handler();
  CLI::App program{"Overlays of polygons: exact decisions, and a valid result for any input.", "oblast"};
  program.set_version_flag("--version", "oblast " OBLAST_VERSION, "print the version");
  program.footer(footer);
  program.require_subcommand(1);
  program.formatter(std::make_shared<HelpFormatter>());
  program.get_help_ptr()->description("print this help");
  Invocation invocation;
  add_union(program, invocation);
  add_overlay(program, invocation);
  add_clip(program, invocation);
  add_erase(program, invocation);
  add_dissolve(program, invocation);
  add_depth(program, invocation);
  add_partition(program, invocation);
  add_buffer(program, invocation);
  add_zones(program, invocation);
  add_repair(program, invocation);
  add_check(program, invocation);
  add_triangulate(program, invocation);
  add_generate(program, invocation);
  add_corpus(program, invocation);
  add_classic(program, invocation);
  add_compare(program, invocation);
  add_hull(program, invocation);
  add_layers(program, invocation);
  add_help(program, invocation);
  for (CLI::App* command : program.get_subcommands({})) command->group("Commands");
  for (const char* const name : {"generate", "corpus", "classic", "compare", "layers"})
    program.get_subcommand(name)->group("Commands for tests and measurements");

  if (argc <= 1) {
    fmt::print(stderr, "{}", program.help());
    return exit_call;
  }
  if (argv[1][0] != '-' && !is_command(program, argv[1])) return refuse_command(program, argv[1]);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return after_parse(program, error);
  }

  const int code = run_command(invocation);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    fmt::print(stderr, "oblast: cannot write to standard output\n");
    return exit_data;
  }
  return code;
}

}  // namespace oblast::app
