// Progress and cancelling of one call.
#pragma once

#include <oblast/error.h>
#include <oblast/options.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>

#include "base/floating_point.h"
#include "base/stopped.h"
#include "base/tuning.h"

namespace oblast::internal {

/// Shared by all stages and threads of one call.
class Control {
 public:
  /// REQUIRES: the options outlive this object. The progress function runs in the environment `callers`.
  explicit Control(const CallOptions& options, bool timed = false,
                   const FloatingPoint& callers = FloatingPoint::current())
      : progress_(options.progress), timed_(timed), callers_(callers) {}
  explicit Control(const Options& options) : Control(options, options.statistics != nullptr) {}

  /// Whether the call measures times. Reading the clock a dozen times takes a tenth of the time of a small call.
  bool timed() const { return timed_; }
  /// Whether the call has a progress function.
  bool asked() const { return static_cast<bool>(progress_); }
  const FloatingPoint& callers() const { return callers_; }

  /// Calls the progress function, at most every few milliseconds and on one thread at a time. If it stops the call,
  /// that thread throws Error(cancelled) or the exception of the function. All other threads throw Stopped, and do not
  /// call the function again.
  void checkpoint() {
    if (!progress_) return;
    if (stopped_.load(std::memory_order_relaxed)) throw Stopped{};
    const Turn turn(asking_);
    if (!turn.taken) return;
    // Another thread may have stopped the call in the meantime.
    if (stopped_.load(std::memory_order_relaxed)) throw Stopped{};
    const auto interval = std::chrono::microseconds(tuning::microseconds_a_question);
    if (std::chrono::steady_clock::now() - asked_ < interval) return;
    ask(next_fraction());
    asked_ = std::chrono::steady_clock::now();
  }

  /// Calls the progress function for the last time, with 1. REQUIRES: no other thread works for the call.
  void finish() {
    if (progress_) ask(1);
  }

  /// The work of the whole call, in the units of advance().
  static constexpr std::uint64_t whole = std::uint64_t{1} << 40;

  void advance(std::uint64_t work) { done_.fetch_add(work, std::memory_order_relaxed); }
  void enter(Stage stage) { stage_.store(stage, std::memory_order_relaxed); }

 private:
  /// Ensures that one thread at a time calls the function, and that the function is not called from itself.
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

  /// The fraction that is done. If it has not grown since the last time, as in a long step without progress, a little
  /// more than the last fraction.
  double next_fraction() {
    const auto done = static_cast<double>(done_.load(std::memory_order_relaxed)) / static_cast<double>(whole);
    constexpr double little = 0x1p-16, most = 1 - 0x1p-20;
    fraction_ = std::max(fraction_ + (1 - fraction_) * little, std::min(done, most));
    return fraction_;
  }

  void ask(double fraction) {
    bool go_on = false;
    try {
      go_on = answer(fraction);
    } catch (...) {
      stopped_.store(true, std::memory_order_relaxed);
      throw;
    }
    if (go_on) return;
    stopped_.store(true, std::memory_order_relaxed);
    throw Error(ErrorCode::cancelled, "the call was cancelled by its progress function");
  }

  /// Calls the progress function.
  bool answer(double fraction) const;

  const Progress& progress_;
  bool timed_;
  FloatingPoint callers_;
  std::atomic<bool> stopped_ = false;
  std::atomic<std::uint64_t> done_ = 0;
  std::atomic<Stage> stage_ = Stage::collect;

  // Used by the thread that calls the function:
  std::atomic_flag asking_;
  std::chrono::steady_clock::time_point asked_;  ///< when the function returned the last time
  double fraction_ = 0;                          ///< the last fraction reported
};

}  // namespace oblast::internal
