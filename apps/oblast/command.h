// How a command joins the program: it adds its options and leaves behind what to run.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <stdexcept>

namespace oblast::app {

/// Exit codes of the program.
inline constexpr int exit_done = 0;
inline constexpr int exit_data = 1;  ///< the data is at fault
inline constexpr int exit_call = 2;  ///< the call is
inline constexpr int exit_interrupted = 130;

/// What main runs once the command line has been read.
struct Invocation {
  std::function<int()> run;  ///< returns an exit code; may throw what program.cpp catches
  bool json = false;         ///< errors are wanted as an object on standard output, too
};

/// The call is at fault: options that contradict each other. Exit code 2.
class CallError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

void add_union(CLI::App& program, Invocation& invocation);
void add_overlay(CLI::App& program, Invocation& invocation);
void add_check(CLI::App& program, Invocation& invocation);
void add_triangulate(CLI::App& program, Invocation& invocation);
void add_corpus(CLI::App& program, Invocation& invocation);
void add_generate(CLI::App& program, Invocation& invocation);
void add_classic(CLI::App& program, Invocation& invocation);
void add_compare(CLI::App& program, Invocation& invocation);
void add_hull(CLI::App& program, Invocation& invocation);
void add_layers(CLI::App& program, Invocation& invocation);

}  // namespace oblast::app
