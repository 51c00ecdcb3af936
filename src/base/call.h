// The context of one call of the library: the state that every thread that works for it shares.
//
//   Call           the state of one call, on the caller's stack
//   WorkingFor     while it exists, this thread works for a call, Call::current(). The loops of parallel.h make one in
//                  every task; it sets everything that must be set on each thread
//   poll()         ends the work if the call was stopped; called in every loop that may be long
//   Steps          the same for a sequential loop, with progress
//
// How a call fails. The Call keeps the first exception that a task throws (Call::attempt). Then stopped() is true, and
// every other task of the call ends with Stopped at its next poll. A loop that has not run all its bodies completely
// throws, so no code continues with arrays that were not filled. The outermost frame (run_call) throws the exception
// that was kept, once.
#pragma once

#include <atomic>
#include <exception>
#include <utility>

#include "base/control.h"
#include "base/floating_point.h"
#include "base/progress.h"
#include "base/stopped.h"
#include "base/tuning.h"

namespace oblast::internal {

class CallMemory;
class KeptBlocks;
class MemoryBudget;

class Call {
 public:
  Call() = default;
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  // Set before the work begins.
  Control* control = nullptr;      ///< null: no progress, no cancelling
  KeptBlocks* blocks = nullptr;    ///< the blocks of its workspace; null: it has none
  CallMemory* memory = nullptr;    ///< the memory of a small call, which stays on its thread, without the scheduler;
                                   ///< null: not a small call
  MemoryBudget* budget = nullptr;  ///< null: no memory limit
  int cores = 1;                   ///< how many threads may work for it

  /// The call that this thread works for, or null.
  static Call* current() { return current_; }

  bool stopped() const { return stopped_.load(std::memory_order_relaxed); }

  /// Throws if the call must end: Stopped, or the exception that the progress function causes.
  void poll() {
    if (stopped()) throw Stopped{};
    if (control) control->checkpoint();
  }

  /// Runs work() and keeps an exception that it throws. Does nothing if the call was stopped.
  template <class Work>
  void attempt(const Work& work) noexcept {
    if (stopped()) return;
    try {
      work();
    } catch (const Stopped&) {
      stopped_.store(true, std::memory_order_relaxed);
    } catch (...) {
      fail(std::current_exception());
    }
  }

  /// Throws the exception that was kept, if any. REQUIRES: all other threads have left the call.
  void rethrow() {
    if (!stopped()) return;
    if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
    throw Stopped{};
  }

 private:
  friend class WorkingFor;
  friend class WorkingForCaller;

  void fail(std::exception_ptr error) noexcept {
    if (!failed_.test_and_set()) error_ = std::move(error);
    stopped_.store(true, std::memory_order_relaxed);
  }

  inline static constinit thread_local Call* current_ = nullptr;

  std::atomic<bool> stopped_ = false;
  std::atomic_flag failed_;
  std::exception_ptr error_;
};

/// While it exists, this thread works for a call, in the floating-point environment that exact arithmetic requires.
class WorkingFor {
 public:
  explicit WorkingFor(Call& call) : outer_(Call::current_) { Call::current_ = &call; }
  WorkingFor(const WorkingFor&) = delete;
  WorkingFor& operator=(const WorkingFor&) = delete;
  ~WorkingFor() { Call::current_ = outer_; }

 private:
  Call* outer_;  ///< the call for which this thread worked before: of another task, or of a function that calls another
  WithFloatingPoint modes_;
  NoShare no_share_;
};

/// While it exists, this thread runs the caller's function, in the caller's environment, and works for no call.
class WorkingForCaller {
 public:
  explicit WorkingForCaller(const FloatingPoint& callers) : outer_(Call::current_), modes_(callers) {
    Call::current_ = nullptr;
  }
  WorkingForCaller(const WorkingForCaller&) = delete;
  WorkingForCaller& operator=(const WorkingForCaller&) = delete;
  ~WorkingForCaller() { Call::current_ = outer_; }

 private:
  Call* outer_;
  WithFloatingPoint modes_;
  NoShare no_share_;
};

/// Throws if the call that this thread works for must end. Cheap enough for every few hundred edges.
inline void poll() {
  if (Call* const call = Call::current()) call->poll();
}

/// Counts the steps of a sequential loop of short steps. Called at each of them. `count`: their number, 0 if unknown.
class Steps {
 public:
  explicit Steps(std::size_t count = 0, std::size_t between_polls = tuning::steps_a_poll)
      : share_(count), between_polls_(between_polls), until_poll_(between_polls) {}

  void operator()() {
    if (--until_poll_ > 0) return;
    until_poll_ = between_polls_;
    share_.advance(between_polls_);
    poll();
  }

 private:
  LoopShare share_;
  std::size_t between_polls_, until_poll_;
};

}  // namespace oblast::internal
