// The signal handler. It uses only functions that are safe in a signal handler: lock-free atomics, write, _exit, and
// two functions of io/write.h that promise it.
#include "oblast/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <csignal>

#include "io/write.h"
#include "oblast/command.h"

namespace oblast::app {

namespace {

std::atomic<bool> flag_is_watched = false;
std::atomic<bool> flag = false;
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void oblast_on_signal(int) {
  if (flag_is_watched && !flag.exchange(true)) return;
  if (!io::stop_outputs()) {  // the result is complete, or will be in a moment
    flag = true;
    return;
  }
  io::discard_unfinished();
  constexpr char message[] = "\noblast: interrupted; unfinished output was removed\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, message, sizeof message - 1);
  ::_exit(exit_interrupted);
}

}  // namespace

void install_interrupt_handler() {
  struct sigaction action = {};
  action.sa_handler = oblast_on_signal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction old = {};
    sigaction(signal, nullptr, &old);
    if (old.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);  // a signal that nohup ignores stays ignored
  }
  // A file at its size limit is then a write error, like a full disk, and does not end the program.
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted() { return flag; }

// In this order: a signal between the two lines ends the program.
void stop_before_more_output() {
  io::expect_more_output();
  if (flag) throw Interrupted();
}

InterruptFlag::InterruptFlag() { flag_is_watched = true; }
InterruptFlag::~InterruptFlag() { flag_is_watched = false; }

void InterruptFlag::end() {
  flag_is_watched = false;
  if (flag) throw Interrupted();
}

}  // namespace oblast::app
