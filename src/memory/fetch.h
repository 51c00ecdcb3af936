// Fetching what will be needed soon into the caches, where the processor cannot foresee it.
#pragma once

namespace oblast {

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

}  // namespace oblast
