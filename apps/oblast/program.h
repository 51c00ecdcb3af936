// The whole program as a function: command line in, exit code out.
#pragma once

namespace oblast::app {

/// Reads the command line, runs the command, turns every failure into a message and an exit code:
/// 0 done, 1 the data is at fault, 2 the call is, 130 interrupted. Throws nothing.
int run_program(int argc, char** argv);

}  // namespace oblast::app
