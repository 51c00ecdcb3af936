// Disjoint sets of indices: union by index, with path halving.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "base/call_memory.h"

namespace oblast::internal {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }

  /// The representative of the set: its smallest index.
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Unites two sets. The smaller root becomes the root, so roots do not depend on the order of the calls.
  void unite(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  Array<std::uint32_t> parent_;
};

}  // namespace oblast::internal
