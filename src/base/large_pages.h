// Large pages for memory that is about to be filled.
//
// A new page takes the system about as long as inserting a dozen points into a triangulation, and a page of 4 KiB holds
// 128 triangles. A walk over scattered elements looks up a page at every step. So long arrays request pages of 2 MiB.
// This is a hint: only the time depends on it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/call_memory.h"
#include "base/pages.h"
#include "base/parallel.h"
#include "base/tuning.h"

namespace oblast::internal {

/// An allocator that does not initialise new elements.
template <class T>
class UninitializedAllocator : public CallAllocator<T> {
 public:
  // The lifetime of trivially copyable and destructible elements begins with their memory.
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

  template <class U>
  struct rebind {
    using other = UninitializedAllocator<U>;
  };
  UninitializedAllocator() = default;
  template <class U>
  explicit UninitializedAllocator(const UninitializedAllocator<U>&) {}

  void construct(T*) {}
  template <class... Arguments>
  void construct(T* at, Arguments&&... arguments) {
    std::construct_at(at, std::forward<Arguments>(arguments)...);
  }
};

/// An array whose resize costs nothing: the code that fills it, on all cores, is the first to touch its pages. Until
/// then new elements have no defined value.
template <class T>
using LargeArray = std::vector<T, UninitializedAllocator<T>>;

/// Reserves `count` elements in large pages, if the system has them.
template <class T, class Allocator>
void reserve_in_large_pages(std::vector<T, Allocator>& items, std::size_t count) {
  if (!items.empty() && items.capacity() < count) {
    // The elements are moved after the pages were requested.
    std::vector<T, Allocator> larger;
    reserve_in_large_pages(larger, count);
    larger.assign(items.begin(), items.end());
    items = std::move(larger);
    return;
  }
  items.reserve(count);
  if (count * sizeof(T) < tuning::large_array_bytes) return;
  char* const begin = reinterpret_cast<char*>(items.data());
  ask_for_large_pages(begin, begin + count * sizeof(T));
}

/// Resizes. New elements hold anything until they are written, and no page is touched. Cost: none but the reservation.
template <class T>
void resize_uninitialized(LargeArray<T>& items, std::size_t count) {
  reserve_in_large_pages(items, count);
  items.resize(count);
}

/// The same for an array that grows often: by a quarter of its length at least, when it has to be moved.
template <class T>
void grow_uninitialized(LargeArray<T>& items, std::size_t count) {
  if (items.capacity() < count) reserve_in_large_pages(items, std::max(count, items.size() + items.size() / 4));
  items.resize(count);
}

/// Resizes. New elements are zeros. All cores fetch the new pages first, since the first touch of one costs most.
template <class T, class Allocator>
void resize_with_zeros(std::vector<T, Allocator>& items, std::size_t count) {
  static_assert(!std::is_same_v<Allocator, UninitializedAllocator<T>>, "its elements would not be zeros");
  if (count * sizeof(T) < tuning::large_array_bytes) {
    items.resize(count);
    return;
  }
  if (items.capacity() < count) reserve_in_large_pages(items, count);
  if (items.size() < count) {
    char* const memory = reinterpret_cast<char*>(items.data() + items.size());
    for_ranges((count - items.size()) * sizeof(T) / tuning::large_array_bytes, tuning::touched_pieces_a_task,
               [&](std::size_t first, std::size_t past) {
                 for (; first < past; ++first) memory[first * tuning::large_array_bytes] = 0;
               });
  }
  items.resize(count);
}

/// Resizes, and writes `value` to all elements, on all cores.
template <class T>
void fill_in_large_pages(LargeArray<T>& items, std::size_t count, const T& value) {
  resize_uninitialized(items, count);
  for_ranges(count, tuning::large_array_bytes / sizeof(T), [&](std::size_t begin, std::size_t end) {
    std::fill(items.begin() + static_cast<std::ptrdiff_t>(begin), items.begin() + static_cast<std::ptrdiff_t>(end),
              value);
  });
}

/// Gives the pages past the last element back to the system; the capacity stays.
template <class T, class Allocator>
void release_unused_pages(std::vector<T, Allocator>& items) {
  char* const begin = reinterpret_cast<char*>(items.data());
  release_pages(begin + items.size() * sizeof(T), begin + items.capacity() * sizeof(T));
}

}  // namespace oblast::internal
