// Counting sort: items go to numbered places, for example to the cells of a grid.
//
//   items     b0 a0 c0 a1 b1      the letter of an item is its place
//   counts    2  2  1             1. each place: how many items it has
//   begins    0  2  4             2. each place: how many items lower places have
//   sorted    a0 a1 b0 b1 c0      3. each item goes to the next free slot of its place, so
//   ends      2  4  5                each begin moves to the end of its place
//
// Items of one place keep their order. No two items are compared, so no branch is hard to foresee.
//
// The items come from `for_each(visit)`, which calls visit(place, item) for each item, twice in the same way. An item
// may go to several places.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace oblast::internal {

/// Step 2: counts become begins. Returns the sum of all counts.
template <class Counts>
typename Counts::value_type counts_to_begins(Counts& counts) {
  typename Counts::value_type sum = 0;
  for (auto& count : counts) count = std::exchange(sum, sum + count);
  return sum;
}

/// Steps 1 and 2. Returns how many items there are. Cost: linear in items and places.
template <class Counts, class ForEach>
typename Counts::value_type count_begins(Counts& begins, const ForEach& for_each) {
  std::fill(begins.begin(), begins.end(), typename Counts::value_type{0});
  for_each([&](std::size_t place, const auto&) { ++begins[place]; });
  return counts_to_begins(begins);
}

/// Step 3: calls put(slot, item). The begins become ends. REQUIRES: begins as count_begins made them.
template <class Counts, class ForEach, class Put>
void put_in_places(Counts& begins, const ForEach& for_each, const Put& put) {
  for_each([&](std::size_t place, const auto& item) { put(begins[place]++, item); });
}

/// All steps: `sorted` becomes the items, place by place, and `ends` where each place ends. REQUIRES: ends has one
/// element for each place.
template <class Counts, class Items, class ForEach>
void counting_sort(Counts& ends, Items& sorted, const ForEach& for_each) {
  sorted.resize(count_begins(ends, for_each));
  put_in_places(ends, for_each, [&](std::size_t slot, const auto& item) { sorted[slot] = item; });
}

/// Step 2 where ranges of the items were counted side by side. counts_of(range)[place] becomes the first slot for the
/// items of that range and place; those of the first range come first.
template <class CountsOf>
void begins_of_ranges(std::size_t ranges, std::size_t places, const CountsOf& counts_of) {
  std::uint32_t sum = 0;
  for (std::size_t place = 0; place < places; ++place) {
    for (std::size_t range = 0; range < ranges; ++range) {
      std::uint32_t& count = counts_of(range)[place];
      count = std::exchange(sum, sum + count);
    }
  }
}

}  // namespace oblast::internal
