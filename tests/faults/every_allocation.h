// Repeats a call. In the first run its first allocation fails, in the second run its second one, and so on.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <new>

#include "faults/allocations.h"

namespace oblast::testing {

/// Ends when a run succeeds without reaching the allocation that would fail. Each run ends with std::bad_alloc, or with
/// the right result (if the code can do without the memory), and leaks nothing. `call` returns false for a wrong
/// result. `after` is called after each run, without failures. More than `fewest` runs are expected.
inline void fail_every_allocation(
    const std::function<bool()>& call, const std::function<void()>& after = [] {}, std::uint64_t fewest = 5) {
  ASSERT_TRUE(call());  // makes objects that are allocated only once
  ASSERT_TRUE(call());
  std::uint64_t number = 1;
  for (bool done = false; !done; ++number) {
    const std::int64_t before = live_blocks();
    try {
      const FailingAllocation failing(number);
      const bool right = call();
      done = failing.count() < number;
      EXPECT_TRUE(right) << "a wrong answer where allocation " << number << " failed";
    } catch (const std::bad_alloc&) {
    }
    ASSERT_EQ(live_blocks(), before) << "leaked where allocation " << number << " failed";
    after();
  }
  EXPECT_GT(number, fewest) << "hardly an allocation was tried";
  EXPECT_TRUE(call()) << "the next call";
}

}  // namespace oblast::testing
