// The whole program as a function of the command line.
#pragma once

namespace oblast::app {

/// Reads the command line, runs the command, and turns every error into a message. Returns the exit code: 0 success, 1
/// an error in the data, 2 an error in the command line, 130 interrupted. Throws nothing.
int run_program(int argc, char** argv);

}  // namespace oblast::app
