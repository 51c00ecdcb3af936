// The progress of a call. The work of the whole call is divided into shares, down to shares of loops, which report what
// they have done. Without a progress function, all of this does nothing.
//
//   Share       the share of a stage, or of a part of the input, in the work around it; by measurement, or by vertices
//   LoopShare   the share of a loop: a quarter of what is left around it, so any number of loops may follow
// A sequential loop uses Steps (call.h).
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/control.h"

namespace oblast::internal {

/// While it exists, the work of this thread is this share of the call. At its end the whole share is done.
class Share {
 public:
  /// The whole call.
  explicit Share(Control& control) : Share(control.asked() ? &control : nullptr, Control::whole, false) {}
  /// A stage, whose share of the work of this thread is `part` (0 to 1).
  Share(Stage stage, double part) : Share(part, false) {
    if (control_ && !inner_) control_->enter(stage);
  }
  /// An inner pipeline, whose stages are not reported.
  explicit Share(double part) : Share(part, true) {}
  /// A part of the share of another thread; null: of nothing.
  Share(Share* of, double part) : Share(of ? of->control_ : nullptr, of ? of->take(part) : 0, of && of->inner_) {}
  Share(const Share&) = delete;
  Share& operator=(const Share&) = delete;
  ~Share() {
    if (!control_) return;
    control_->advance(left_.load(std::memory_order_relaxed));
    current_ = outer_;
  }

  /// The share of this thread; null without a progress function, or in a task that has no share.
  static Share* current() { return current_; }

  /// Reports that so many units of the share are done, or as many as are left.
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

/// While it exists, the work of this thread does not count: for a task of a loop, which counts its pieces itself.
class NoShare {
 public:
  NoShare() : outer_(std::exchange(Share::current_, nullptr)) {}
  NoShare(const NoShare&) = delete;
  NoShare& operator=(const NoShare&) = delete;
  ~NoShare() { Share::current_ = outer_; }

 private:
  Share* outer_;
};

/// What a loop over `count` pieces adds to the share of the thread that starts it.
class LoopShare {
 public:
  explicit LoopShare(std::size_t count) : share_(Share::current()) {
    if (share_ && count > 0) a_piece_ = static_cast<double>(share_->left()) / 4 / static_cast<double>(count);
  }

  /// May be called on any thread while the share exists.
  void advance(std::size_t pieces) const {
    if (share_) share_->advance(static_cast<std::uint64_t>(a_piece_ * static_cast<double>(pieces)));
  }

 private:
  Share* share_;
  double a_piece_ = 0;
};

}  // namespace oblast::internal
