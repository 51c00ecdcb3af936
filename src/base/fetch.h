// Prefetches memory that will be used soon, if the processor cannot predict the access.
#pragma once

#include <cstddef>

namespace oblast::internal {

/// A hint: only the time depends on it.
inline void fetch(const void* address) {
  __builtin_prefetch(address);
  // Without this, g++ 12 considers the function to have no effect, and removes calls of it.
  asm volatile("");
}
inline void fetch_to_write(const void* address) {
  __builtin_prefetch(address, 1);
  asm volatile("");
}

/// Prefetches an element of an array, with its neighbours in the cache line.
template <class Items>
void fetch_around(const Items& items, std::size_t index) {
  fetch(&items[index - (index > 0)]);
  fetch(&items[index + (index + 1 < items.size())]);
}

}  // namespace oblast::internal
