// How far a call is: the work of the whole call is parted into shares, down to those of loops, which add to what is
// done as they go. Where nobody asks all of this is nothing.
//
//   Share       what a stage, or a part of the input, is of what surrounds it; by measurement, or by vertices
//   LoopShare   of a loop: a quarter of what its surroundings have left, so that any number of loops may follow
// A sequential loop has Steps (call.h).
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/control.h"

namespace oblast::internal {

/// While it lives, what this thread does is this share of the call. At its end all of it is done.
class Share {
 public:
  /// The whole call.
  explicit Share(Control& control) : Share(control.asked() ? &control : nullptr, Control::whole, false) {}
  /// A stage, so much (0 to 1) of what this thread does.
  Share(Stage stage, double part) : Share(part, false) {
    if (control_ && !inner_) control_->enter(stage);
  }
  /// An inner pipeline, whose stages are nobody's concern.
  explicit Share(double part) : Share(part, true) {}
  /// A part of what another thread does; null: of nothing.
  Share(Share* of, double part) : Share(of ? of->control_ : nullptr, of ? of->take(part) : 0, of && of->inner_) {}
  Share(const Share&) = delete;
  Share& operator=(const Share&) = delete;
  ~Share() {
    if (!control_) return;
    control_->advance(left_.load(std::memory_order_relaxed));
    current_ = outer_;
  }

  /// Of this thread; null where nobody asks, or in a task that has none.
  static Share* current() { return current_; }

  /// So many units of it are done, or as many as are left.
  void advance(std::uint64_t work) { control_->advance(take_units(work)); }
  std::uint64_t left() const { return left_.load(std::memory_order_relaxed); }

 private:
  friend class NoShare;

  Share(double part, bool inner)
      : Share(current_ ? current_->control_ : nullptr, current_ ? current_->take(part) : 0,
              inner || (current_ && current_->inner_)) {}
  Share(Control* control, std::uint64_t size, bool inner)
      : control_(control), size_(size), left_(size), inner_(inner), outer_(current_) {
    if (control_) current_ = this;
  }

  std::uint64_t take(double part) { return take_units(static_cast<std::uint64_t>(static_cast<double>(size_) * part)); }
  std::uint64_t take_units(std::uint64_t wanted) {
    std::uint64_t left = left_.load(std::memory_order_relaxed), taken = 0;
    do taken = std::min(wanted, left);
    while (!left_.compare_exchange_weak(left, left - taken, std::memory_order_relaxed));
    return taken;
  }

  inline static constinit thread_local Share* current_ = nullptr;

  Control* control_;
  std::uint64_t size_;
  std::atomic<std::uint64_t> left_;
  bool inner_;
  Share* outer_;
};

/// While it lives, what this thread does counts for nothing: a task, of which the loop counts the pieces.
class NoShare {
 public:
  NoShare() : outer_(std::exchange(Share::current_, nullptr)) {}
  NoShare(const NoShare&) = delete;
  NoShare& operator=(const NoShare&) = delete;
  ~NoShare() { Share::current_ = outer_; }

 private:
  Share* outer_;
};

/// What a loop over `count` pieces adds to the share of the thread that begins it.
class LoopShare {
 public:
  explicit LoopShare(std::size_t count) : share_(Share::current()) {
    if (share_ && count > 0) a_piece_ = static_cast<double>(share_->left()) / 4 / static_cast<double>(count);
  }

  /// From any thread, for as long as the share lives.
  void advance(std::size_t pieces) const {
    if (share_) share_->advance(static_cast<std::uint64_t>(a_piece_ * static_cast<double>(pieces)));
  }

 private:
  Share* share_;
  double a_piece_ = 0;
};

}  // namespace oblast::internal
