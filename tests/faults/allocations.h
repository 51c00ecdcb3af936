// Counts every operator new of this program, and can make one of them fail.
#pragma once

#include <cstdint>

namespace oblast::testing {

/// The number of blocks from operator new that are not yet deleted.
std::int64_t live_blocks();

/// While it exists, the `number`-th operator new from now on, in any thread, throws std::bad_alloc. 0: none throws;
/// they are only counted. All others succeed.
class FailingAllocation {
 public:
  explicit FailingAllocation(std::uint64_t number);
  ~FailingAllocation();
  FailingAllocation(const FailingAllocation&) = delete;
  FailingAllocation& operator=(const FailingAllocation&) = delete;

  /// The number of calls of operator new so far.
  std::uint64_t count() const;
};

}  // namespace oblast::testing
