// A loop over ranges of indices, on all cores where there is enough to do.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>

#include "memory/call_memory.h"

namespace oblast {

/// Calls body(begin, end) for ranges of [0, count), side by side where there are more than `grain` indices. A small
/// call (call_memory.h) stays clear of the scheduler, whose start costs as much as overlaying a few dozen edges.
template <class Body>
void for_ranges(std::size_t count, std::size_t grain, const Body& body) {
  if (count <= grain || CallMemory::current() != nullptr) {
    if (count > 0) body(std::size_t{0}, count);
    return;
  }
  KeptBlocks* const blocks = KeptBlocks::current();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      const LargeCall call(blocks);
                      body(range.begin(), range.end());
                    });
}

/// On how many cores for_ranges works: on one in a small call.
inline std::size_t core_count() {
  return CallMemory::current() ? 1 : static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
}

/// So many of `count` indices that have about 2^15 of `parts` parts: the grain of a loop over parts, as the vertices of
/// chains, where they may be many to an index or few.
constexpr std::size_t grain(std::size_t count, std::size_t parts) {
  constexpr std::size_t parts_a_task = 1 << 15;
  return 1 + parts_a_task * count / (count + parts + 1);
}

/// How many ranges of `size` indices, the last of them shorter, make up [0, count).
constexpr std::size_t range_count(std::size_t count, std::size_t size) { return (count + size - 1) / size; }

/// Calls body(i, begin, end) for the i-th of these ranges, side by side: the same ones on any number of cores, so that
/// what is found in each can be kept by its number.
template <class Body>
void for_numbered_ranges(std::size_t count, std::size_t size, const Body& body) {
  for_ranges(range_count(count, size), 1, [&](std::size_t i, std::size_t past) {
    for (; i < past; ++i) body(i, i * size, (i + 1) * size < count ? (i + 1) * size : count);
  });
}

}  // namespace oblast
