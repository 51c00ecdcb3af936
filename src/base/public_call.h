// The frame of every public function: it checks the options and runs the work in a Call.
#pragma once

#include <oblast/options.h>

#include <cassert>
#include <cstddef>
#include <optional>
#include <type_traits>

#include "base/call_memory.h"
#include "base/check_options.h"
#include "base/control.h"
#include "base/index.h"
#include "base/memory_budget.h"
#include "base/parallel.h"
#include "base/tuning.h"

namespace oblast::internal {

namespace detail {

/// Not inlined: the compiler must not move its computations out of the environment that is set (base/floating_point.h).
template <class Work>
[[gnu::noinline]] auto perform(const Work& work, Control& control) {
  return work(control);
}

}  // namespace detail

/// Runs work(control), for a call on so many vertices of input, and returns its result. If another public function
/// makes the call, it is a part of that function's call, with its threads, limit, progress and environment. Throws
/// Error: bad_option, too_large, memory_limit, cancelled, and what the work and the progress function throw.
template <class Work>
auto public_call(const CallOptions& options, bool timed, std::size_t vertices, const Work& work) {
  using Result = std::invoke_result_t<const Work&, Control&>;
  check_options(options);
  check_count(vertices, "vertices in one call", most_vertices);
  if (const Call* const outer = Call::current(); outer && outer->control) return work(*outer->control);
  Control control(options, timed, FloatingPoint::current());
  std::optional<MemoryBudget> budget;
  Call call;
  call.control = &control;
  if (options.most_bytes > 0) call.budget = &budget.emplace(options.most_bytes);
  if (vertices <= tuning::small_call) {
    // A small call has its own memory and stays on this thread.
    CallMemory memory;
    call.memory = &memory;
    call.blocks = kept_blocks(options.workspace, vertices);
    const WorkingFor working(call);
    Result result = detail::perform(work, control);
    control.finish();
    return result;
  }
  call.blocks = kept_blocks(options.workspace, vertices);
  std::optional<Result> result;
  run_call(call, options.threads, [&] {
    {
      const Share whole(control);
      result.emplace(detail::perform(work, control));
    }
    control.finish();
  });
  // This does not hold if the call failed: a thread that has left the call then drops tasks that were not begun, with
  // their arrays.
  assert(!budget || budget->used_bytes() == 0);
  return *std::move(result);
}
template <class Work>
auto public_call(const CallOptions& options, std::size_t vertices, const Work& work) {
  return public_call(options, false, vertices, work);
}

}  // namespace oblast::internal
