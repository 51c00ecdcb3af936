// A memory resource for containers. Its blocks count towards the memory limit, as those of all arrays do.
#pragma once

#include <cstddef>
#include <memory_resource>

#include "base/kept_blocks.h"

namespace oblast::internal {

class BlockResource : public std::pmr::memory_resource {
 private:
  // REQUIRES, for both functions: the alignment is at most that of operator new.
  void* do_allocate(std::size_t bytes, std::size_t) override { return take_block(bytes); }
  void do_deallocate(void* block, std::size_t bytes, std::size_t) override { give_block_back(block, bytes); }
  bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }
};

}  // namespace oblast::internal
