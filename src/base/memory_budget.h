// The memory limit of a call: CallOptions::most_bytes.
//
// Blocks of arrays are counted when they are taken and given back (take_block), with one atomic number per call.
// Results, whose arrays belong to the caller, are counted by a Charge while the call holds them. Calls without a limit
// count nothing. Small calls count only the blocks that their own memory cannot hold.
#pragma once

#include <oblast/region_set.h>

#include <atomic>
#include <cstddef>
#include <utility>

#include "base/call.h"

namespace oblast::internal {

class MemoryBudget {
 public:
  /// REQUIRES: most_bytes > 0.
  explicit MemoryBudget(std::size_t most_bytes) : most_bytes_(most_bytes) {}
  MemoryBudget(const MemoryBudget&) = delete;
  MemoryBudget& operator=(const MemoryBudget&) = delete;

  /// The budget of the call that this thread works for; null if it has no limit.
  static MemoryBudget* current() {
    const Call* const call = Call::current();
    return call ? call->budget : nullptr;
  }

  /// Counts the bytes. If they exceed the limit, counts nothing and throws Error(memory_limit).
  void take(std::size_t bytes) {
    if (used_.fetch_add(bytes, std::memory_order_relaxed) + bytes > most_bytes_) [[unlikely]]
      refuse(bytes);
  }
  void give_back(std::size_t bytes) { used_.fetch_sub(bytes, std::memory_order_relaxed); }

  std::size_t used_bytes() const { return used_.load(std::memory_order_relaxed); }

 private:
  [[noreturn]] void refuse(std::size_t bytes);

  std::size_t most_bytes_;
  std::atomic<std::size_t> used_ = 0;
};

/// Counts bytes of a result, which are not blocks of an array, while it exists. Throws Error(memory_limit).
class Charge {
 public:
  Charge() = default;
  explicit Charge(std::size_t bytes) : budget_(MemoryBudget::current()), bytes_(bytes) {
    if (budget_) budget_->take(bytes);
  }
  Charge(Charge&& other) noexcept : budget_(std::exchange(other.budget_, nullptr)), bytes_(other.bytes_) {}
  Charge& operator=(Charge&& other) noexcept {
    std::swap(budget_, other.budget_);
    std::swap(bytes_, other.bytes_);
    return *this;
  }
  ~Charge() {
    if (budget_) budget_->give_back(bytes_);
  }

  /// The bytes stay counted after this object is destroyed.
  void keep() { budget_ = nullptr; }

 private:
  MemoryBudget* budget_ = nullptr;
  std::size_t bytes_ = 0;
};

constexpr std::size_t bytes_of_regions(std::size_t points, std::size_t contours, std::size_t polygons) {
  return points * sizeof(Point) + (contours + polygons) * sizeof(std::uint32_t);
}
inline std::size_t bytes_of(const RegionView& regions) {
  return bytes_of_regions(regions.points.size(), regions.contour_ends.size(), regions.polygon_ends.size());
}

}  // namespace oblast::internal
