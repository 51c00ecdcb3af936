// Work on all cores. Only this file calls oneTBB (tools/lint checks this).
//
//   run_call                          runs the work of a call, on the threads that it may use
//   for_ranges, for_numbered_ranges   loops over ranges of indices
//   parallel_sort
//   TaskGroup                         tasks that can start other tasks
//   PerThread                         one object per thread
//   isolated                          a thread that waits inside starts no task from outside
//
// A loop that returns has run all of its bodies; otherwise it throws (call.h). oneTBB's own handling of exceptions is
// not used: if a task throws, oneTBB cancels the group, and loops nested in other tasks return without having run all
// bodies. So nothing is thrown into oneTBB, and each loop has a context of its own. Neither another loop of the call
// nor a caller whose tasks call the library can cancel it.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "base/call.h"
#include "base/tuning.h"

namespace oblast::internal {

/// The number of threads that work for a call which asks for `threads`. oneTBB starts no more than the process has
/// cores, unless the caller allows more (tbb::global_control), and prints a warning if it is asked for more.
inline int allowed_threads(int threads) {
  if (threads < 2) return threads;
  const std::size_t allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return static_cast<int>(std::min(static_cast<std::size_t>(threads), allowed));
}

/// Runs the work of a call on up to `threads` threads, including this one (0: all threads of the caller's arena), and
/// throws what it throws. With one thread, the scheduler is not used.
template <class Work>
void run_call(Call& call, int threads, const Work& work) {
  threads = allowed_threads(threads);
  const auto whole = [&] {
    if (threads != 1) call.cores = tbb::this_task_arena::max_concurrency();
    call.attempt([&] {
      const WorkingFor working(call);
      work();
    });
  };
  if (threads == 1)
    whole();
  else if (threads == 0)
    // A thread that waits for other threads of this call runs no other tasks of the caller.
    tbb::this_task_arena::isolate(whole);
  else
    tbb::task_arena(threads).execute(whole);
  call.rethrow();
}

/// The same for work outside of a call, such as a test that calls a single stage. Inside a call it only runs work().
template <class Work>
void within_call(const Work& work) {
  if (Call::current()) return work();
  Call call;
  run_call(call, 0, work);
}

/// The number of cores that loops use. One in a small call.
inline std::size_t core_count() {
  const Call* const call = Call::current();
  return static_cast<std::size_t>(call ? call->cores : tbb::this_task_arena::max_concurrency());
}

/// Runs work(). A thread that waits in it starts no task from outside, because waits would nest.
template <class Work>
void isolated(const Work& work) {
  if (core_count() == 1)
    work();
  else
    tbb::this_task_arena::isolate(work);
}

namespace detail {

/// Divides the range of a task into ranges no longer than the grain, so each call of the body is short.
template <class Body>
void run_ranges(Call& call, const LoopShare& share, std::size_t begin, std::size_t end, std::size_t grain,
                const Body& body) {
  const NoShare no_share;
  for (std::size_t next = begin; begin < end; begin = next) {
    next = end - begin > grain ? begin + grain : end;
    call.poll();
    body(begin, next);
    share.advance(next - begin);
  }
}

template <class Body>
void share_ranges(Call& call, std::size_t count, std::size_t grain, const Body& body) {
  const LoopShare share(count);
  tbb::task_group_context context(tbb::task_group_context::isolated);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, grain),
      [&](const tbb::blocked_range<std::size_t>& range) {
        call.attempt([&] {
          const WorkingFor working(call);
          run_ranges(call, share, range.begin(), range.end(), grain, body);
        });
      },
      tbb::auto_partitioner(), context);
  if (call.stopped() || context.is_group_execution_cancelled()) throw Stopped{};
}

}  // namespace detail

/// Calls body(begin, end) for ranges of at most `grain` indices of [0, count), in parallel if there are several. A
/// small call does not use the scheduler, because its start takes as long as the overlay of a few dozen edges.
/// REQUIRES: grain > 0.
template <class Body>
void for_ranges(std::size_t count, std::size_t grain, const Body& body) {
  Call* const call = Call::current();
  if (count <= grain || (call && call->memory)) {
    if (count > 0) body(std::size_t{0}, count);
  } else if (!call) {
    within_call([&] { for_ranges(count, grain, body); });
  } else if (call->cores == 1) {
    detail::run_ranges(*call, LoopShare(count), 0, count, grain, body);
  } else {
    detail::share_ranges(*call, count, grain, body);
  }
}

/// The grain of a loop over `count` indices with `parts` parts in total, such as chains with their vertices: the number
/// of indices that have about tuning::parts_a_task parts.
constexpr std::size_t grain(std::size_t count, std::size_t parts) {
  return 1 + tuning::parts_a_task * count / (count + parts + 1);
}

/// The number of ranges of `size` indices that make up [0, count). The last one may be shorter.
constexpr std::size_t range_count(std::size_t count, std::size_t size) { return (count + size - 1) / size; }

/// Calls body(i, begin, end) for the i-th of these ranges, in parallel. The ranges do not depend on the number of
/// cores, so results can be stored by the number of the range.
template <class Body>
void for_numbered_ranges(std::size_t count, std::size_t size, const Body& body) {
  for_ranges(range_count(count, size), 1, [&](std::size_t i, std::size_t past) {
    for (; i < past; ++i) body(i, i * size, (i + 1) * size < count ? (i + 1) * size : count);
  });
}

/// Tasks that can start other tasks.
class TaskGroup {
 public:
  /// Calls work(group). Returns when work and all tasks of the group have ended.
  template <class Work>
  static void run(const Work& work) {
    within_call([&] {
      TaskGroup group(*Call::current());
      group.call_.attempt([&] { work(group); });
      if (!group.finish()) throw Stopped{};
    });
  }

  /// Starts a task: task() will be called, as const, on this thread or another one.
  template <class Task>
  void add(Task task) {
    auto attempt = [this, task = std::move(task)] {
      call_.attempt([&] {
        const WorkingFor working(call_);
        call_.poll();
        task();
      });
    };
    if (call_.cores == 1)
      pending_.emplace_back(std::move(attempt));
    else
      tasks_.run(std::move(attempt));
  }

 private:
  explicit TaskGroup(Call& call) : call_(call) {}

  /// False if some tasks were not done.
  bool finish() {
    while (!pending_.empty()) {
      const std::function<void()> task = std::move(pending_.back());
      pending_.pop_back();
      task();
    }
    return tasks_.wait() == tbb::complete && !call_.stopped();
  }

  Call& call_;
  tbb::task_group_context context_{tbb::task_group_context::isolated};
  tbb::task_group tasks_{context_};
  std::vector<std::function<void()>> pending_;  ///< used on one core
};

/// An object for each thread that uses one.
template <class T>
using PerThread = tbb::enumerable_thread_specific<T>;

namespace detail {

/// Sorts in place, by halves of about the same size; each half is a task. The steps do not depend on the number of
/// cores.
template <class Iterator, class Less>
void sort_in_tasks(Iterator first, Iterator last, int depth, const Less& less, TaskGroup& group) {
  while (last - first > tuning::sorted_items_of_one_task && depth-- > 0) {
    poll();
    const auto at = [&](int i) -> const auto& { return first[(last - first - 1) / 8 * i]; };
    const auto median = [&](const auto& a, const auto& b, const auto& c) -> const auto& {
      if (less(a, b)) return less(b, c) ? b : less(a, c) ? c : a;
      return less(a, c) ? a : less(b, c) ? c : b;
    };
    const auto pivot = median(median(at(0), at(1), at(2)), median(at(3), at(4), at(5)), median(at(6), at(7), at(8)));
    Iterator middle = std::partition(first, last, [&](const auto& item) { return less(item, pivot); });
    if (middle == first) {
      // No item is less than the pivot. Items that equal it are in their final place.
      first = std::partition(first, last, [&](const auto& item) { return !less(pivot, item); });
      continue;
    }
    group.add([=, &less, &group] { sort_in_tasks(first, middle, depth, less, group); });
    first = middle;
  }
  poll();
  std::sort(first, last, less);
}

}  // namespace detail

/// As std::sort, with the same result on any number of cores. (oneTBB's own sort cannot be stopped.)
template <class Iterator, class Less = std::less<>>
void parallel_sort(Iterator first, Iterator last, const Less& less = {}) {
  const Call* const call = Call::current();
  if (last - first <= tuning::sorted_items_of_one_task || (call && call->memory)) {
    std::sort(first, last, less);
    return;
  }
  TaskGroup::run([&](TaskGroup& group) {
    int depth = 1;  // deeper only if the halves are very uneven
    for (auto count = last - first; count > 0; count /= 2) depth += 2;
    detail::sort_in_tasks(first, last, depth, less, group);
  });
}

}  // namespace oblast::internal
