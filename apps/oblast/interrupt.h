// Ctrl-C and other signals that end the program: old output stays, temporary files are removed, the exit code is 130.
//
// While an overlay runs, the first signal only sets a flag. The overlay tests the flag and ends with Error(cancelled).
// At any other time, and at a second signal, the handler removes unfinished files and ends the program at once.
//
// From the moment in which a finished file replaces an older one, a signal only sets the flag. If no more output is to
// follow, the program ends with exit code 0: the new output is there, and whole.
#pragma once

#include <exception>

namespace oblast::app {

/// The user stopped the program.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// Installs the handler for SIGINT, SIGTERM and SIGHUP.
void install_interrupt_handler();

/// True after a signal that set the flag.
bool interrupted();

/// Call this between two outputs. Throws Interrupted if a signal came after the first was complete.
void stop_before_more_output();

/// While an object of this class exists, a first signal sets the flag and does not end the program.
class InterruptFlag {
 public:
  InterruptFlag();
  ~InterruptFlag();
  /// Call this when the work is done: from now on a signal ends the program. Throws Interrupted if a signal came
  /// before.
  void end();
  InterruptFlag(const InterruptFlag&) = delete;
  InterruptFlag& operator=(const InterruptFlag&) = delete;
};

}  // namespace oblast::app
