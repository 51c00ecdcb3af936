// Fetching what will be needed soon into the caches, where the processor cannot foresee it.
#pragma once

#include <cstddef>

namespace oblast::internal {

/// It is advice: nothing depends on it but time.
inline void fetch(const void* address) {
  __builtin_prefetch(address);
  // A function that does nothing but this has no effect, says the compiler (g++ 12), and leaves out the call of it.
  asm volatile("");
}
inline void fetch_to_write(const void* address) {
  __builtin_prefetch(address, 1);
  asm volatile("");
}

/// An element of an array with the ones beside it.
template <class Items>
void fetch_around(const Items& items, std::size_t index) {
  fetch(&items[index - (index > 0)]);
  fetch(&items[index + (index + 1 < items.size())]);
}

}  // namespace oblast::internal
