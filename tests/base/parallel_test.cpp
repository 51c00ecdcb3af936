// Loops and tasks run completely or throw, whatever fails. An exception is thrown once and unchanged.
#include "base/parallel.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <new>
#include <set>
#include <thread>
#include <vector>

#include "generators/random.h"

namespace oblast::internal {
namespace {

/// What no library throws.
struct Thrown {
  int value;
};

void work_a_moment() { std::this_thread::sleep_for(std::chrono::microseconds(20)); }

/// How many threads work on a loop of this many ranges, in a call that asks for `threads`. Ranges take a millisecond
/// until `expected` threads have come.
std::size_t working_threads(int threads, std::size_t expected, std::size_t ranges = 20000) {
  std::mutex mutex;
  std::set<std::thread::id> seen;
  Call call;
  run_call(call, threads, [&] {
    for_ranges(ranges, 1, [&](std::size_t, std::size_t) {
      {
        const std::lock_guard lock(mutex);
        seen.insert(std::this_thread::get_id());
        if (seen.size() >= expected) return;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    });
  });
  return seen.size();
}

// Other tests ask for eight threads; without eight_threads.cpp these would be as few as the machine has cores.
TEST(Parallel, asManyThreadsWorkAsAreAskedFor) {
  for (const std::size_t threads : {1, 2, 8}) EXPECT_EQ(working_threads(static_cast<int>(threads), threads), threads);
}

TEST(Parallel, noMoreThreadsWorkThanTheProcessAllows) {
  const tbb::global_control three(tbb::global_control::max_allowed_parallelism, 3);
  Call call;
  run_call(call, 8, [] { EXPECT_EQ(core_count(), 3u); });
  EXPECT_LE(working_threads(8, 4, 300), 3u);
}

TEST(Parallel, loopsRunEachIndexOnce) {
  for (const int threads : {1, 2, 8}) {
    for (const std::size_t count : {0, 1, 7, 64, 1000, 10007}) {
      for (const std::size_t grain : {1, 3, 64, 5000}) {
        std::vector<std::atomic<int>> runs(count);
        Call call;
        run_call(call, threads, [&] {
          for_ranges(count, grain, [&](std::size_t begin, std::size_t end) {
            EXPECT_LE(end - begin, grain);
            for (; begin < end; ++begin) ++runs[begin];
          });
        });
        for (const auto& times : runs) ASSERT_EQ(times, 1) << threads << " threads, grain " << grain;
      }
    }
  }
}

// The fault of oneTBB's own cancelling: if one task throws, loops nested in other tasks return without having run.
TEST(Parallel, aNestedLoopThatReturnsHasRunAllItsBodies) {
  constexpr std::size_t outer = 12, inner = 48;
  std::atomic<int> incomplete = 0, complete = 0, thrown = 0;
  constexpr int trials = 60;
  for (int trial = 0; trial < trials; ++trial) {
    Call call;
    try {
      run_call(call, 8, [&] {
        for_ranges(outer, 1, [&](std::size_t i, std::size_t) {
          if (i == static_cast<std::size_t>(trial) % outer) throw Thrown{trial};
          std::vector<std::uint8_t> done(inner, 0);
          for_ranges(inner, 1, [&](std::size_t k, std::size_t) {
            work_a_moment();
            done[k] = 1;
          });
          const bool all = std::all_of(done.begin(), done.end(), [](std::uint8_t d) { return d != 0; });
          ++(all ? complete : incomplete);
        });
      });
      ADD_FAILURE() << "nothing was thrown";
    } catch (const Thrown& caught) {
      EXPECT_EQ(caught.value, trial);
      ++thrown;
    }
  }
  EXPECT_EQ(incomplete, 0) << "loops looked done, and were not";
  EXPECT_EQ(thrown, trials);
  EXPECT_GT(complete, 0) << "no loop came to its end: then nothing was tested";
}

TEST(Parallel, theFirstExceptionComesOutAsItWentIn) {
  for (const int threads : {1, 2, 8}) {
    Call call;
    EXPECT_THROW(run_call(call, threads, [] { for_ranges(1000, 1, [](auto, auto) { throw std::bad_alloc(); }); }),
                 std::bad_alloc);
    const auto made = std::make_exception_ptr(Thrown{7});
    Call other;
    try {
      run_call(other, threads, [&] {
        TaskGroup::run([&](TaskGroup& tasks) {
          tasks.add([&] { for_ranges(100, 1, [&](auto, auto) { std::rethrow_exception(made); }); });
        });
      });
      ADD_FAILURE() << "nothing was thrown";
    } catch (const Thrown&) {
      EXPECT_EQ(std::current_exception(), made) << "a copy, or another one";
    }
  }
}

TEST(Parallel, whatTheWorkThrowsBesideItsTasksWaitsForThem) {
  for (const int threads : {1, 8}) {
    std::atomic<int> under_way = 0;
    Call call;
    EXPECT_THROW(run_call(call, threads,
                          [&] {
                            TaskGroup::run([&](TaskGroup& tasks) {
                              for (int i = 0; i < 50; ++i)
                                tasks.add([&] {
                                  ++under_way;
                                  work_a_moment();
                                  --under_way;
                                });
                              throw Thrown{1};
                            });
                          }),
                 Thrown);
    EXPECT_EQ(under_way, 0);
  }
}

TEST(Parallel, oneThreadIsTheCallersOwn) {
  Call call;
  const std::thread::id here = std::this_thread::get_id();
  std::atomic<int> elsewhere = 0;
  const auto note = [&] { elsewhere += std::this_thread::get_id() != here; };
  run_call(call, 1, [&] {
    for_ranges(2000, 1, [&](auto, auto) {
      note();
      work_a_moment();
    });
    TaskGroup::run([&](TaskGroup& tasks) {
      for (int i = 0; i < 200; ++i) {
        tasks.add([&] {
          note();
          work_a_moment();
        });
      }
    });
  });
  EXPECT_EQ(elsewhere, 0);
}

TEST(Parallel, everyTaskWorksForItsCall) {
  Call outer;
  run_call(outer, 8, [&] {
    for_ranges(200, 1, [&](std::size_t i, auto) {
      EXPECT_EQ(Call::current(), &outer);
      if (i % 50 == 0) {
        Call inner;
        run_call(inner, 2, [&] {
          for_ranges(50, 1, [&](auto, auto) { EXPECT_EQ(Call::current(), &inner); });
          EXPECT_EQ(Call::current(), &inner);
        });
      }
      EXPECT_EQ(Call::current(), &outer);
    });
  });
  EXPECT_EQ(Call::current(), nullptr);
}

TEST(Parallel, aCallersCancelledTasksTakeNothingFromACall) {
  std::atomic<int> incomplete = 0;
  for (int trial = 0; trial < 50; ++trial) {
    tbb::task_group group;
    std::atomic<bool> begun = false;
    for (int t = 0; t < 4; ++t) {
      group.run([&] {
        std::vector<std::uint8_t> done(512, 0);
        Call call;
        run_call(call, 0, [&] {
          for_ranges(done.size(), 1, [&](std::size_t i, auto) {
            begun = true;
            work_a_moment();
            done[i] = 1;
          });
        });
        incomplete += std::find(done.begin(), done.end(), 0) != done.end();
      });
    }
    std::thread canceller([&] {
      while (!begun) std::this_thread::yield();
      group.cancel();
    });
    group.wait();
    canceller.join();
  }
  EXPECT_EQ(incomplete, 0);
}

TEST(Parallel, sortsAsStdSortDoes) {
  generators::Random random(1);
  for (const int threads : {1, 2, 8}) {
    for (const int size : {0, 1, 2, 1000, 8192, 8193, 60000, 200000}) {
      for (const int different : {1, 2, 100, 1 << 30}) {
        std::vector<int> items(static_cast<std::size_t>(size));
        for (int& item : items) item = static_cast<int>(random.below(different));
        for (int order = 0; order < 3; ++order) {
          if (order == 1) std::sort(items.begin(), items.end());
          if (order == 2) std::reverse(items.begin(), items.end());
          std::vector<int> expected = items, sorted = items;
          std::sort(expected.begin(), expected.end());
          Call call;
          run_call(call, threads, [&] { parallel_sort(sorted.begin(), sorted.end()); });
          ASSERT_EQ(sorted, expected) << size << " items of " << different << ", order " << order;
        }
      }
    }
  }
}

TEST(Parallel, sortsTiesTheSameOnAnyNumberOfThreads) {
  generators::Random random(2);
  std::vector<std::pair<int, int>> items(100000);
  for (int i = 0; i < 100000; ++i) items[static_cast<std::size_t>(i)] = {static_cast<int>(random.below(50)), i};
  std::vector<std::vector<std::pair<int, int>>> sorted;
  for (const int threads : {1, 2, 8}) {
    sorted.push_back(items);
    Call call;
    run_call(call, threads, [&] {
      parallel_sort(sorted.back().begin(), sorted.back().end(),
                    [](const auto& p, const auto& q) { return p.first < q.first; });
    });
  }
  EXPECT_EQ(sorted[0], sorted[1]);
  EXPECT_EQ(sorted[0], sorted[2]);
}

TEST(Parallel, perThreadObjectsAreNotShared) {
  PerThread<std::vector<int>> found;
  Call call;
  run_call(call, 8,
           [&] { for_ranges(5000, 1, [&](std::size_t i, auto) { found.local().push_back(static_cast<int>(i)); }); });
  std::set<int> all;
  std::size_t count = 0;
  for (const std::vector<int>& part : found) {
    all.insert(part.begin(), part.end());
    count += part.size();
  }
  EXPECT_EQ(all.size(), 5000u);
  EXPECT_EQ(count, 5000u);
}

}  // namespace
}  // namespace oblast::internal
