// Addresses of more points than the machine has memory for: none of it is touched.
#pragma once

#include <oblast/point.h>
#include <sys/mman.h>

#include <cstddef>
#include <span>

namespace oblast::testing {

class ReservedPoints {
 public:
  explicit ReservedPoints(std::size_t count) : count_(count) {
    void* const address = mmap(nullptr, bytes(), PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    points_ = address == MAP_FAILED ? nullptr : static_cast<const Point*>(address);
  }
  ReservedPoints(const ReservedPoints&) = delete;
  ReservedPoints& operator=(const ReservedPoints&) = delete;
  ~ReservedPoints() {
    if (points_) munmap(const_cast<Point*>(points_), bytes());
  }

  /// Whether the system gave them.
  bool there() const { return points_ != nullptr; }
  std::span<const Point> first(std::size_t count) const { return {points_, count}; }

 private:
  std::size_t bytes() const { return count_ * sizeof(Point); }

  std::size_t count_;
  const Point* points_;
};

}  // namespace oblast::testing
