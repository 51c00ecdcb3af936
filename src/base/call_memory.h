// The memory of a call.
//
// A call on a few dozen edges makes some eighty small arrays. Getting each from the system takes a fifth of its time.
// So a small call has memory on its stack, and a freed array is reused by the next one of about the same size. Such a
// call stays on its thread, so nothing is shared. If this memory is used up, and in larger calls, arrays come from the
// system, or, if they are long, from the workspace of the call (kept_blocks.h).
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

// The address sanitizer finds faults only in blocks of the system.
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

/// The memory of one small call (Call::memory), used by one thread. No array outlives it: results of calls are plain
/// vectors.
class CallMemory {
 public:
  CallMemory() = default;
  CallMemory(const CallMemory&) = delete;
  CallMemory& operator=(const CallMemory&) = delete;
  ~CallMemory() {
    if (more_) give_uncounted_block_back(more_, more_capacity);
  }

  /// The memory of the small call that this thread works for, or null.
  static CallMemory* current() {
    const Call* const call = Call::current();
    return call ? call->memory : nullptr;
  }

  /// Null if the memory is used up.
  void* take(std::size_t bytes) {
    if (sanitized) return nullptr;
    const std::size_t size_class = size_class_of(bytes);
    if (size_class >= class_count) return nullptr;
    if (Freed* const freed = freed_[size_class]) {
      freed_[size_class] = freed->next;
      return freed;
    }
    const std::size_t size = smallest_block << size_class;
    if (size <= capacity - used_) {
      used_ += size;
      return memory_.data() + used_ - size;
    }
    return take_more(size);
  }

  /// False if the block is not from this memory.
  bool give_back(void* block, std::size_t bytes) {
    if (!is_in(block, memory_.data(), capacity) && !(more_ && is_in(block, more_, more_capacity))) return false;
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

  static bool is_in(const void* block, const std::byte* begin, std::size_t size) {
    return reinterpret_cast<std::uintptr_t>(block) - reinterpret_cast<std::uintptr_t>(begin) < size;
  }

  /// From a block that the call's workspace keeps. Null if there is no workspace, or the block is used up.
  void* take_more(std::size_t size) {
    const Call* const call = Call::current();
    if (!call || !call->blocks) return nullptr;
    if (!more_) more_ = static_cast<std::byte*>(take_uncounted_block(more_capacity));
    if (size > more_capacity - more_used_) return nullptr;
    more_used_ += size;
    return more_ + more_used_ - size;
  }

  static constexpr std::size_t more_capacity = tuning::small_call_kept_bytes;

  std::size_t used_ = 0, more_used_ = 0;
  std::byte* more_ = nullptr;
  std::array<Freed*, class_count> freed_{};
  alignas(64) std::array<std::byte, capacity> memory_;  // not initialised
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

/// A vector that does not outlive the call in which it is made.
template <class T>
using Array = std::vector<T, CallAllocator<T>>;

}  // namespace oblast::internal
