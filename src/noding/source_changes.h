// What an edge adds to the sources of a face, and what it takes away, when it is crossed from its right to its left.
//
// Where rows are overlaid, a winding number for each operand is not enough: each row has its own. A change is then a
// set of sources with counts, and Winding carries a handle of it for each operand:
//
//   0                    no change
//   +(s + 1)             source s once more; nearly all edges have such a change
//   +(source_count + i)  the set i of the table below
//   +(first_pair + i)    one source once more and another one once less: an edge between two rows of a coverage
//   -h                   the opposite of h: the same edge, seen along its other direction
//
// So noding compares and turns changes as it does winding numbers, and only their sum needs the table. Sets share their
// branches (source_sets.h): to add up a thousand copies of an edge, one by one, takes memory for a few thousand
// branches. A change may have two handles, that of its set and that of the opposite set turned; then a strand is
// divided where it need not be, which makes no difference to a result.
#pragma once

#include <cstdint>
#include <mutex>

#include "noding/source_sets.h"

namespace oblast::internal::noding {

class SourceChanges {
 public:
  /// Throws Error(too_large) where that many sources have no handles.
  explicit SourceChanges(std::size_t source_count);

  /// The handle of the sum; 0 if nothing is left. From any thread. Cost: O(32) for each source of q.
  std::int32_t add(std::int32_t p, std::int32_t q);

  /// The handle of: `more` once more, `less` once less. REQUIRES: they differ. From one thread, not while others add.
  std::int32_t add_pair(std::uint32_t more, std::uint32_t less);

  /// Calls visit(source, count) for each source that changes, in order (of a pair: the one that counts more is first).
  /// Not while another thread adds.
  template <class Visit>
  void for_each(std::int32_t handle, const Visit& visit) const {
    if (handle == 0) return;
    const std::int32_t sign = handle < 0 ? -1 : 1;
    const auto number = static_cast<std::uint32_t>(sign * handle);
    if (number <= source_count_) return visit(number - 1, sign);
    if (number >= first_pair) {
      const Pair pair = pairs_[number - first_pair];
      visit(pair.more, sign);
      return visit(pair.less, -sign);
    }
    sets_.for_each_count(number - source_count_,
                         [&](std::uint32_t source, std::int32_t count) { visit(source, sign * count); });
  }

 private:
  struct Pair {
    std::uint32_t more, less;
  };
  static constexpr std::uint32_t first_pair = std::uint32_t{1} << 30;

  std::int32_t sum_of(std::int32_t p, std::int32_t q);
  SourceSets::Set set_of(std::uint32_t number);

  std::uint32_t source_count_;
  std::mutex mutex_;
  SourceSets sets_;
  Array<Pair> pairs_;
  /// Borders are long: what was added last is often asked for again.
  std::int32_t last_p_ = 0, last_q_ = 0, last_sum_ = 0;
};

}  // namespace oblast::internal::noding
