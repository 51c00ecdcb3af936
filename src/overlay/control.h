// Progress, cancelling and times of one call.
#pragma once

#include <oblast/error.h>
#include <oblast/options.h>

#include <atomic>
#include <chrono>
#include <mutex>

namespace oblast {

/// Shared by all stages and threads of one call.
class Control {
 public:
  explicit Control(const Options& options) : progress_(options.progress), timed_(options.statistics != nullptr) {}

  /// Whether anybody asks for times: to look at the clock a dozen times costs a small call a tenth of its own.
  bool timed() const { return timed_; }

  /// Asks the caller, at most every few milliseconds and from one thread at a time, whether to go on.
  /// Throws Error(cancelled). Cheap enough for every thousand edges.
  void checkpoint(Stage stage, double fraction) {
    if (!progress_) return;
    if (cancelled_.load(std::memory_order_relaxed)) throw_cancelled();
    const std::unique_lock lock(mutex_, std::try_to_lock);
    const auto now = std::chrono::steady_clock::now();
    if (!lock.owns_lock() || (now - asked_ < std::chrono::milliseconds(5) && stage == stage_)) return;
    asked_ = now;
    stage_ = stage;
    if (progress_(stage, fraction)) return;
    cancelled_.store(true, std::memory_order_relaxed);
    throw_cancelled();
  }

 private:
  [[noreturn]] static void throw_cancelled() { throw Error(ErrorCode::cancelled, "the overlay was cancelled"); }

  const Progress& progress_;
  bool timed_;
  std::mutex mutex_;
  std::chrono::steady_clock::time_point asked_;
  Stage stage_ = Stage::assemble;
  std::atomic<bool> cancelled_ = false;
};

/// Adds the time from its making to its end to a stage, where the call is timed.
class StageClock {
 public:
  StageClock(const Control& control, Statistics& statistics, Stage stage) {
    if (!control.timed()) return;
    seconds_ = &statistics.seconds[static_cast<int>(stage)];
    begin_ = std::chrono::steady_clock::now();
  }
  StageClock(const StageClock&) = delete;
  StageClock& operator=(const StageClock&) = delete;
  ~StageClock() {
    if (seconds_) *seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  double* seconds_ = nullptr;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace oblast
