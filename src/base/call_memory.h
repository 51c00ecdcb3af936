// Memory of a call.
//
// A call of a few dozen edges makes some eighty small arrays, and to ask the system for each takes a fifth of its time.
// So a small call brings its memory with it, and what is freed is taken again by the next array of about that size.
// Such a call stays on its thread, so nothing there is shared. When the memory is used up, and in larger calls, arrays
// come from the system; long ones from the call's workspace, where it has one (kept_blocks.h).
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

#include "base/call.h"
#include "base/kept_blocks.h"
#include "base/tuning.h"

namespace oblast::internal {

// The address sanitizer sees what is wrong within the system's blocks only.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif
#else
inline constexpr bool sanitized = false;
#endif

/// The memory of one small call (Call::memory), for the thread that makes it. Nothing outlives it: what a call returns
/// is made of plain vectors.
class CallMemory {
 public:
  CallMemory() = default;
  CallMemory(const CallMemory&) = delete;
  CallMemory& operator=(const CallMemory&) = delete;
  ~CallMemory() = default;

  /// Of the small call that this thread is in; null in none.
  static CallMemory* current() {
    const Call* const call = Call::current();
    return call ? call->memory : nullptr;
  }

  /// Null where it is used up.
  void* take(std::size_t bytes) {
    if (sanitized) return nullptr;
    const std::size_t size_class = size_class_of(bytes);
    if (size_class >= class_count) return nullptr;
    if (Freed* const freed = freed_[size_class]) {
      freed_[size_class] = freed->next;
      return freed;
    }
    const std::size_t size = smallest_block << size_class;
    if (size > capacity - used_) return nullptr;
    used_ += size;
    return memory_.data() + used_ - size;
  }

  /// False where it is not from here.
  bool give_back(void* block, std::size_t bytes) {
    const std::uintptr_t offset =
        reinterpret_cast<std::uintptr_t>(block) - reinterpret_cast<std::uintptr_t>(memory_.data());
    if (offset >= capacity) return false;
    const std::size_t size_class = size_class_of(bytes);
    freed_[size_class] = new (block) Freed{freed_[size_class]};
    return true;
  }

 private:
  struct Freed {
    Freed* next;
  };
  static constexpr std::size_t capacity = tuning::call_memory_bytes, smallest_block = 32,
                               class_count = tuning::call_memory_sizes;

  static std::size_t size_class_of(std::size_t bytes) {
    return static_cast<std::size_t>(std::bit_width((bytes - (bytes > 0)) / smallest_block));
  }

  std::size_t used_ = 0;
  std::array<Freed*, class_count> freed_{};
  alignas(64) std::array<std::byte, capacity> memory_;  // not written before it is used
};

template <class T>
class CallAllocator {
 public:
  using value_type = T;
  static_assert(alignof(T) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);

  CallAllocator() = default;
  template <class U>
  explicit(false) CallAllocator(const CallAllocator<U>&) {}

  T* allocate(std::size_t count) {
    if (count > std::size_t(-1) / 2 / sizeof(T)) throw std::bad_array_new_length();
    if (CallMemory* const memory = CallMemory::current())
      if (void* const block = memory->take(count * sizeof(T))) return static_cast<T*>(block);
    return static_cast<T*>(take_block(count * sizeof(T)));
  }
  void deallocate(T* block, std::size_t count) {
    if (CallMemory* const memory = CallMemory::current())
      if (memory->give_back(block, count * sizeof(T))) return;
    give_block_back(block, count * sizeof(T));
  }

  friend bool operator==(const CallAllocator&, const CallAllocator&) { return true; }
};

/// A vector that lives no longer than the call it is made in.
template <class T>
using Array = std::vector<T, CallAllocator<T>>;

}  // namespace oblast::internal
