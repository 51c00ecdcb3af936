// Every operator new of this program, counted, and one of them made to fail.
#pragma once

#include <cstdint>

namespace oblast::testing {

/// Blocks from operator new that are not deleted yet.
std::int64_t live_blocks();

/// While it lives, the `number`-th operator new from now on, in any thread, throws std::bad_alloc; 0: none does, they
/// are only counted. All others are served.
class FailingAllocation {
 public:
  explicit FailingAllocation(std::uint64_t number);
  ~FailingAllocation();
  FailingAllocation(const FailingAllocation&) = delete;
  FailingAllocation& operator=(const FailingAllocation&) = delete;

  /// How many there were so far.
  std::uint64_t count() const;
};

}  // namespace oblast::testing
