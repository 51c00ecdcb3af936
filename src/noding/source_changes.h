// What an edge adds to the sources of a face, and what it takes away, when it is crossed from its right to its left.
//
// Where rows are overlaid, a winding number for each operand is not enough: each row has its own. A change is then a
// list of (source, count), and Winding carries a handle of it for each operand:
//
//   0                 no change
//   +(s + 1)          source s once more; nearly all edges have such a change
//   +(sources + 1 + i)   the list number i below
//   -h                the opposite of h: the same edge, seen along its other direction
//
// Equal changes have equal handles. So noding compares and turns them as it does winding numbers, and only their sum
// needs this table.
#pragma once

#include <cstdint>
#include <mutex>
#include <span>

#include "base/call_memory.h"

namespace oblast::internal::noding {

class SourceChanges {
 public:
  struct Item {
    std::uint32_t source;
    std::int32_t count;  ///< not 0

    friend bool operator==(const Item&, const Item&) = default;
  };

  /// Throws Error(too_large) where that many sources have no handles.
  explicit SourceChanges(std::size_t source_count);

  /// The handle of the sum. From any thread. Cost: linear in the lists, expected; those of one source are short.
  std::int32_t add(std::int32_t p, std::int32_t q);

  /// Calls visit(source, count) for each item, in the order of the sources. Not while another thread adds.
  template <class Visit>
  void for_each(std::int32_t handle, const Visit& visit) const {
    if (handle == 0) return;
    const std::int32_t sign = handle < 0 ? -1 : 1;
    const auto number = static_cast<std::uint32_t>(sign * handle) - 1;
    if (number < source_count_) return visit(number, sign);
    for (const Item& item : list(number - source_count_)) visit(item.source, sign * item.count);
  }

 private:
  std::span<const Item> list(std::uint32_t i) const {
    const std::uint32_t begin = i == 0 ? 0 : ends_[i - 1];
    return std::span(items_).subspan(begin, ends_[i] - begin);
  }
  std::int32_t sum_of(std::int32_t p, std::int32_t q);
  std::int32_t handle_of(std::span<const Item> list);
  void grow();

  std::uint32_t source_count_;
  std::mutex mutex_;
  Array<Item> items_, sum_;
  Array<std::uint32_t> ends_;   ///< by list: past its last item
  Array<std::uint32_t> slots_;  ///< hash table of lists
  /// Borders are long: what was added last is often asked for again.
  std::int32_t last_p_ = 0, last_q_ = 0, last_sum_ = 0;
};

}  // namespace oblast::internal::noding
