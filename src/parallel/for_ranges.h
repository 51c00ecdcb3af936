// A loop over ranges of indices, on all cores where there is enough to do.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

namespace oblast {

/// Calls body(begin, end) for ranges of [0, count), side by side where there are more than `grain` indices. A small
/// call stays clear of the scheduler, whose start costs as much as overlaying a few dozen edges.
template <class Body>
void for_ranges(std::size_t count, std::size_t grain, const Body& body) {
  if (count <= grain) {
    if (count > 0) body(std::size_t{0}, count);
    return;
  }
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                    [&](const tbb::blocked_range<std::size_t>& range) { body(range.begin(), range.end()); });
}

}  // namespace oblast
