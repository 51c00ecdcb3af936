// Ctrl-C and its kin: the old output stays, temporary files go, the exit code is 130.
//
// While an overlay runs, the first signal only raises a flag, which the overlay asks for (it then ends
// by Error(cancelled)). At any other time, and for a second signal, the handler removes what is half
// written and ends the program at once; but not while finished files are renamed, when it is too late.
#pragma once

#include <exception>

namespace oblast::app {

/// The user asked to stop.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// Handles SIGINT, SIGTERM and SIGHUP from now on.
void install_interrupt_handler();

/// True once a signal came while an InterruptFlag lived.
bool interrupted();

/// While it lives, a first signal raises the flag instead of ending the program.
class InterruptFlag {
 public:
  InterruptFlag();
  ~InterruptFlag();
  /// The work is done: from now on a signal ends the program. Throws Interrupted where one came before.
  void end();
  InterruptFlag(const InterruptFlag&) = delete;
  InterruptFlag& operator=(const InterruptFlag&) = delete;
};

}  // namespace oblast::app
