// The interface between a command and the program: a command adds its options and sets the function to run.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "oblast/cli.h"

namespace oblast::app {

/// Exit codes of the program.
inline constexpr int exit_done = 0;
inline constexpr int exit_data = 1;  ///< an error in the data
inline constexpr int exit_call = 2;  ///< an error in the command line
inline constexpr int exit_interrupted = 130;

/// What the program runs after it has read the command line.
struct Invocation {
  std::function<int()> run;  ///< returns an exit code; may throw what program.cpp catches
  bool json = false;         ///< print errors as an object, too
  std::string output = {};   ///< where the result goes; `-`: the object is printed on standard error
};

/// An error in the command line: options that contradict each other. Exit code 2.
class CallError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

void add_union(CLI::App& program, Invocation& invocation);
void add_overlay(CLI::App& program, Invocation& invocation);
void add_clip(CLI::App& program, Invocation& invocation);
void add_erase(CLI::App& program, Invocation& invocation);
void add_dissolve(CLI::App& program, Invocation& invocation);
void add_depth(CLI::App& program, Invocation& invocation);
void add_partition(CLI::App& program, Invocation& invocation);
void add_buffer(CLI::App& program, Invocation& invocation);
void add_zones(CLI::App& program, Invocation& invocation);
void add_repair(CLI::App& program, Invocation& invocation);
void add_check(CLI::App& program, Invocation& invocation);
void add_triangulate(CLI::App& program, Invocation& invocation);
void add_corpus(CLI::App& program, Invocation& invocation);
void add_generate(CLI::App& program, Invocation& invocation);
void add_classic(CLI::App& program, Invocation& invocation);
void add_compare(CLI::App& program, Invocation& invocation);
void add_hull(CLI::App& program, Invocation& invocation);
void add_layers(CLI::App& program, Invocation& invocation);
void add_help(CLI::App& program, Invocation& invocation);

}  // namespace oblast::app
