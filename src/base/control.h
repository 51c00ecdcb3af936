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
  /// The options live as long as this does. The caller's function runs in the environment `callers`.
  explicit Control(const CallOptions& options, bool timed = false,
                   const FloatingPoint& callers = FloatingPoint::current())
      : progress_(options.progress), timed_(timed), callers_(callers) {}
  explicit Control(const Options& options) : Control(options, options.statistics != nullptr) {}

  /// Whether anybody asks for times: to look at the clock a dozen times costs a small call a tenth of its own.
  bool timed() const { return timed_; }
  /// Whether anybody asks how far the call is.
  bool asked() const { return static_cast<bool>(progress_); }
  const FloatingPoint& callers() const { return callers_; }

  /// Asks the caller, at most every few milliseconds and from one thread at a time, whether to go on. Throws
  /// Error(cancelled), or what the caller's function throws, on the thread that got this answer; Stopped on all others,
  /// which ask no more.
  void checkpoint() {
    if (!progress_) return;
    if (stopped_.load(std::memory_order_relaxed)) throw Stopped{};
    const Turn turn(asking_);
    if (!turn.taken) return;
    // Another thread may have been told to stop since.
    if (stopped_.load(std::memory_order_relaxed)) throw Stopped{};
    const auto interval = std::chrono::microseconds(tuning::microseconds_a_question);
    if (std::chrono::steady_clock::now() - asked_ < interval) return;
    ask(next_fraction());
    asked_ = std::chrono::steady_clock::now();
  }

  /// The last question: all is done. REQUIRES: no other thread works for the call.
  void finish() {
    if (progress_) ask(1);
  }

  /// The work of the call, in the units of what it is advanced by.
  static constexpr std::uint64_t whole = std::uint64_t{1} << 40;

  void advance(std::uint64_t work) { done_.fetch_add(work, std::memory_order_relaxed); }
  void enter(Stage stage) { stage_.store(stage, std::memory_order_relaxed); }

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

  /// Of what is done; a little more than last time where that is not more, as in a long step of which nobody knows how
  /// far it is.
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
    throw Error(ErrorCode::cancelled, "the call was cancelled");
  }

  /// What the caller's function says.
  bool answer(double fraction) const;

  const Progress& progress_;
  bool timed_;
  FloatingPoint callers_;
  std::atomic<bool> stopped_ = false;
  std::atomic<std::uint64_t> done_ = 0;
  std::atomic<Stage> stage_ = Stage::collect;

  // Of the thread that asks:
  std::atomic_flag asking_;
  std::chrono::steady_clock::time_point asked_;  ///< when the last question was answered
  double fraction_ = 0;                          ///< of the last question
};

}  // namespace oblast::internal
