// Progress and cancelling of one call.
#pragma once

#include <oblast/error.h>
#include <oblast/options.h>

#include <atomic>
#include <chrono>

#include "base/stopped.h"

namespace oblast {

/// Shared by all stages and threads of one call.
class Control {
 public:
  /// The options live as long as this does.
  explicit Control(const Options& options) : progress_(options.progress), timed_(options.statistics != nullptr) {}

  /// Whether anybody asks for times: to look at the clock a dozen times costs a small call a tenth of its own.
  bool timed() const { return timed_; }

  /// Asks the caller, at most every few milliseconds and from one thread at a time, whether to go on. Throws
  /// Error(cancelled), or what the caller's function throws, on the thread that got this answer; Stopped on all others,
  /// which ask no more.
  void checkpoint(Stage stage, double fraction) {
    if (!progress_) return;
    check();
    const Turn turn(asking_);
    if (!turn.taken) return;
    check();
    const bool next_stage = stage != stage_;
    stage_ = stage;
    fraction_ = fraction;
    ask_if_due(next_stage);
  }

  /// The same, in the stage of the last question.
  void checkpoint() {
    if (!progress_) return;
    check();
    const Turn turn(asking_);
    if (!turn.taken) return;
    check();
    ask_if_due(false);
  }

 private:
  /// One thread at a time asks, and not from within the caller's function.
  struct Turn {
    explicit Turn(std::atomic_flag& asking) : flag(asking), taken(!asking.test_and_set(std::memory_order_acquire)) {}
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;
    ~Turn() {
      if (taken) flag.clear(std::memory_order_release);
    }
    std::atomic_flag& flag;
    bool taken;
  };

  void check() const {
    if (stopped_.load(std::memory_order_relaxed)) throw Stopped{};
  }

  void ask_if_due(bool at_once) {
    const auto now = std::chrono::steady_clock::now();
    if (!at_once && now - asked_ < std::chrono::milliseconds(5)) return;
    asked_ = now;
    bool go_on = false;
    try {
      go_on = progress_(stage_, fraction_);
    } catch (...) {
      stopped_.store(true, std::memory_order_relaxed);
      throw;
    }
    if (go_on) return;
    stopped_.store(true, std::memory_order_relaxed);
    throw Error(ErrorCode::cancelled, "the call was cancelled");
  }

  const Progress& progress_;
  bool timed_;
  std::atomic_flag asking_;
  std::chrono::steady_clock::time_point asked_;
  Stage stage_ = Stage::collect;
  double fraction_ = 0;
  std::atomic<bool> stopped_ = false;
};

}  // namespace oblast
