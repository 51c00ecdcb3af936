// The context of one call of the library: what must be the same on every thread that works for it.
//
//   Call           of one call, made on the caller's stack
//   WorkingFor     while it lives, this thread works for a call: Call::current(). The loops of parallel.h make one in
//                  every task, so whatever has to be set on each thread is set there
//   poll()         whether to go on: in every loop that may be long
//   Steps          the same in a sequential loop, with progress
//
// How a call fails. What is thrown in a task is kept in the Call, the first of all (Call::attempt); from then on
// stopped() is true, and every other task of the call ends by Stopped at its next poll. A loop whose bodies did not all
// run to their end throws, so nobody goes on with arrays that were not filled. The outermost frame (run_call) throws
// what was kept: once, and as it was thrown.
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
  Control* control = nullptr;    ///< null: nobody asks
  KeptBlocks* blocks = nullptr;  ///< of its workspace; null: it has none
  CallMemory* memory =
      nullptr;  ///< of a small call, which stays on its thread, clear of the scheduler; null: not small
  MemoryBudget* budget = nullptr;  ///< null: it may have any memory
  int cores = 1;                   ///< how many threads may work for it

  /// The one that this thread works for; null: none.
  static Call* current() { return current_; }

  bool stopped() const { return stopped_.load(std::memory_order_relaxed); }

  /// Throws where the call is to end: Stopped, or what the caller's progress function made of it.
  void poll() {
    if (stopped()) throw Stopped{};
    if (control) control->checkpoint();
  }

  /// Does work and keeps what it throws. It does not begin once the call has stopped.
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

  /// REQUIRES: every thread but this one has left the call. Throws what was kept, where there is something.
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

/// While it lives, this thread works for a call, in the floating-point environment that exact arithmetic needs.
class WorkingFor {
 public:
  explicit WorkingFor(Call& call) : outer_(Call::current_) { Call::current_ = &call; }
  WorkingFor(const WorkingFor&) = delete;
  WorkingFor& operator=(const WorkingFor&) = delete;
  ~WorkingFor() { Call::current_ = outer_; }

 private:
  Call* outer_;  ///< of a task of another call, or of a function that makes use of another
  WithFloatingPoint modes_;
  NoShare no_share_;
};

/// While it lives, this thread runs the caller's own function, in the caller's environment, and works for no call.
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

/// Throws where the call that this thread works for is to end. Cheap enough for every few hundred edges.
inline void poll() {
  if (Call* const call = Call::current()) call->poll();
}

/// In a sequential loop of short steps, so many (0: not known): called at each of them.
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
