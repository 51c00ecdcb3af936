// A call made again and again, its first allocation failing, then its second, and so on.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <new>

#include "faults/allocations.h"

namespace oblast::testing {

/// Until one run needs no more allocations than were failed before it. Each run ends with std::bad_alloc or with the
/// right answer (where the code can do without), and leaks nothing. `call` returns false for a wrong answer; `after` is
/// called after each run, when nothing fails. More than `fewest` runs are expected.
inline void fail_every_allocation(
    const std::function<bool()>& call, const std::function<void()>& after = [] {}, std::uint64_t fewest = 5) {
  ASSERT_TRUE(call());  // what is made once and for all is made now
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
