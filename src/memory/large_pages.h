// Large pages for memory that is about to be filled.
//
// A new page costs the system about as much as inserting a dozen points into a triangulation, and a page of 4 KiB holds
// 128 triangles; and a walk over scattered elements looks up a page at every step. So where arrays grow long, pages of
// 2 MiB are asked for. It is advice: nothing depends on it but time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace oblast {

/// Reserves `count` elements in large pages where the system has them.
template <class T>
void reserve_in_large_pages(std::vector<T>& items, std::size_t count) {
  if (!items.empty() && items.capacity() < count) {
    // What is there is moved when the pages are asked for already.
    std::vector<T> larger;
    reserve_in_large_pages(larger, count);
    larger.assign(items.begin(), items.end());
    items = std::move(larger);
    return;
  }
  items.reserve(count);
#ifdef __linux__
  constexpr std::uintptr_t page = std::uintptr_t{2} << 20;
  const auto begin = reinterpret_cast<std::uintptr_t>(items.data());
  const std::uintptr_t first = (begin + page - 1) / page * page, last = (begin + count * sizeof(T)) / page * page;
  if (first < last) madvise(reinterpret_cast<char*>(items.data()) + (first - begin), last - first, MADV_HUGEPAGE);
#endif
}

/// The same for an empty array, and makes them.
template <class T>
void resize_in_large_pages(std::vector<T>& items, std::size_t count, const T& value = {}) {
  reserve_in_large_pages(items, count);
  items.resize(count, value);
}

}  // namespace oblast
