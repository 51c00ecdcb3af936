// What the steps of the check find.
#pragma once

#include <oblast/check.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>

#include "base/index.h"

namespace oblast::internal::checking {

/// A fault, by vertices of the regions.
struct Finding {
  FaultKind kind;
  std::uint32_t vertex;        ///< where it is; the edge that begins there, where edges are at fault
  std::uint32_t other = none;  ///< the second one concerned
  Point point = {};

  std::uint64_t key() const { return static_cast<std::uint64_t>(vertex) << 32 | other; }
};

/// Of many, the one with the smallest vertices. Offered from several threads at once.
class FirstFinding {
 public:
  void offer(const Finding& finding) {
    if (finding.key() >= smallest_.load(std::memory_order_relaxed)) return;
    const std::lock_guard lock(mutex_);
    if (finding.key() >= smallest_.load(std::memory_order_relaxed)) return;
    finding_ = finding;
    smallest_.store(finding.key(), std::memory_order_relaxed);
  }

  /// REQUIRES: nobody offers any more.
  const std::optional<Finding>& get() const { return finding_; }

 private:
  std::atomic<std::uint64_t> smallest_ = 0xffff'ffff'ffff'ffff;
  std::mutex mutex_;
  std::optional<Finding> finding_;
};

}  // namespace oblast::internal::checking
