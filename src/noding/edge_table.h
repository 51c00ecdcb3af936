// A table that finds to every edge the first one with the same two ends, in either direction.
#pragma once

#include <oblast/point.h>

#include <bit>
#include <cstddef>
#include <cstdint>

#include "base/call_memory.h"
#include "base/fetch.h"
#include "base/index.h"
#include "base/large_pages.h"

namespace oblast::internal::noding {

/// Open addressing. REQUIRES: at most `most_edges` different edges are put in.
class EdgeTable {
 public:
  EdgeTable(const LargeArray<Point>& points, std::size_t most_edges)
      : points_(points), slots_(std::bit_ceil(most_edges + most_edges / 2 + 2), none), mask_(slots_.size() - 1) {}

  void prefetch(std::uint32_t hash) const { fetch_to_write(&slots_[hash & mask_]); }
  /// The first edge with the ends of this one; the edge itself when it is new. `hash` is by edge_hash().
  std::uint32_t find_or_insert(std::uint32_t edge, std::uint32_t hash) {
    const Point &a = points_[edge], &b = points_[edge + 1];
    for (std::uint64_t slot = hash;; ++slot) {
      std::uint32_t& entry = slots_[slot & mask_];
      if (entry == none) return entry = edge;
      const Point &c = points_[entry], &d = points_[entry + 1];
      if ((a == d && b == c) || (a == c && b == d)) return entry;
    }
  }

 private:
  const LargeArray<Point>& points_;
  Array<std::uint32_t> slots_;
  std::uint64_t mask_;
};

}  // namespace oblast::internal::noding
