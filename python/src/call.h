// How Python calls the library: without the interpreter's lock, with progress and Ctrl-C, with errors that name the
// row.
#pragma once

#include <nanobind/nanobind.h>
#include <oblast/error.h>
#include <oblast/options.h>
#include <oblast/workspace.h>

#include <functional>
#include <vector>

#include "arrays.h"

namespace oblast::python {

/// What a call is told, apart from its operands. `progress` is None or a callable that takes the fraction that is done.
struct Settings {
  Options options;  ///< without progress; with threads, fill rules and so on
  nb::object progress = nb::none();
  nb::object workspace = nb::none();  ///< kept alive; options.workspace points into it

  /// options, with the members that every call has taken from `common`.
  Options with(const CallOptions& common) const {
    Options all = options;
    static_cast<CallOptions&>(all) = common;
    return all;
  }
};

using Work = std::function<void(const CallOptions&)>;
using Operands = std::vector<const Arrays*>;

/// Runs `work` without the lock. A call on more than some hundred vertices runs on a thread of its own, while this one
/// looks for signals and reports progress; Python is called on this thread only. What a signal handler or `progress`
/// raises stops the work and is thrown here. An Error becomes oblast.OblastError; operand n of the error is
/// operands[n], which tells the row. With `quick`, the work is short and is not watched unless `progress` is set.
void run(const Settings& settings, const Operands& operands, const Work& work, bool quick = false);

/// Raises oblast.OblastError. `row` is for errors that have no ring.
[[noreturn]] void raise_error(const Error& error, const Operands& operands, std::size_t row = Place::npos);

/// The number of threads that a call may have: 1 in a process that was forked, because the threads of oneTBB are not
/// copied by a fork.
int usable_threads(int threads);
/// Called once, when the module is loaded.
void note_forks();

}  // namespace oblast::python
