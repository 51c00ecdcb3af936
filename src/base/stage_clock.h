// Times of the stages of one call.
#pragma once

#include <oblast/options.h>

#include <chrono>

#include "base/call.h"
#include "base/control.h"

namespace oblast::internal {

/// Adds the time from its construction to its destruction to a stage, if the call is timed.
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

/// A stage of a call, while it exists. Polls whether the call must end, then counts progress (as a share of the work of
/// this thread) and measures the time.
class InStage {
 public:
  InStage(Stage stage, double share, const Control& control, Statistics& statistics)
      : share_((poll(), stage), share), clock_(control, statistics, stage) {}

 private:
  Share share_;
  StageClock clock_;
};

}  // namespace oblast::internal
