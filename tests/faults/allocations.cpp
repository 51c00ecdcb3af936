// Replaces operator new and delete by malloc and free, with counters.
#include "faults/allocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::int64_t> live{0};
std::atomic<std::uint64_t> requested{0}, failing{0};

bool fails() {
  const std::uint64_t number = requested.fetch_add(1) + 1;
  return number == failing.load();
}

void* counted(void* block) {
  if (block) ++live;
  return block;
}

void* allocate(std::size_t size) {
  void* block = fails() ? nullptr : counted(std::malloc(size == 0 ? 1 : size));
  if (!block) throw std::bad_alloc();
  return block;
}

void* allocate(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  void* block = fails() ? nullptr : counted(std::aligned_alloc(step, (size + step - 1) / step * step));
  if (!block) throw std::bad_alloc();
  return block;
}

void release(void* block) {
  if (block) --live;
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void* operator new(std::size_t size, std::align_val_t alignment) { return allocate(size, alignment); }
void* operator new[](std::size_t size, std::align_val_t alignment) { return allocate(size, alignment); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return fails() ? nullptr : counted(std::malloc(size == 0 ? 1 : size));
}
void* operator new[](std::size_t size, const std::nothrow_t& tag) noexcept { return operator new(size, tag); }
void operator delete(void* block) noexcept { release(block); }
void operator delete[](void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete[](void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, std::align_val_t) noexcept { release(block); }
void operator delete[](void* block, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { release(block); }
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, const std::nothrow_t&) noexcept { release(block); }
void operator delete[](void* block, const std::nothrow_t&) noexcept { release(block); }

namespace oblast::testing {

std::int64_t live_blocks() { return live; }

FailingAllocation::FailingAllocation(std::uint64_t number) {
  requested = 0;
  failing = number;
}

FailingAllocation::~FailingAllocation() { failing = 0; }

std::uint64_t FailingAllocation::count() const { return requested; }

}  // namespace oblast::testing
