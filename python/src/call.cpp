#include "call.h"

#include <oblast/error.h>
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

namespace oblast::python {

namespace {

// With so few vertices a call takes less time than a signal may wait.
constexpr std::size_t least_watched_vertices = 500;
constexpr std::chrono::milliseconds between_looks{20};

bool was_forked = false;

bool on_main_thread() { return gettid() == getpid(); }

/// The work of one call on a thread of its own, seen from the thread that waits for it.
class WatchedWork {
 public:
  WatchedWork(const CallOptions& common, const Work& work) : thread_([this, common, &work] { do_it(common, work); }) {}
  ~WatchedWork() { thread_.join(); }

  bool wait() {
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, between_looks, [&] { return done_; });
  }
  double fraction() const { return fraction_; }
  void stop() { stopped_ = true; }
  /// REQUIRES: the work has ended.
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  void do_it(CallOptions common, const Work& work) {
    common.progress = [this](Stage, double fraction) {
      fraction_ = fraction;
      return !stopped_;
    };
    try {
      work(common);
    } catch (...) {
      thrown_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    done_ = true;
    ended_.notify_one();
  }

  std::atomic<double> fraction_ = 0;
  std::atomic<bool> stopped_ = false;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool done_ = false;
  std::exception_ptr thrown_;
  std::thread thread_;  // the last member: it uses the others
};

// Reports, and looks for signals. False: a Python error is set.
bool look(const nb::object& progress, double fraction) {
  if (PyErr_CheckSignals() != 0) return false;
  if (progress.is_none()) return true;
  PyObject* answer = PyObject_CallFunction(progress.ptr(), "d", fraction);
  Py_XDECREF(answer);
  return answer != nullptr;
}

void run_watched(const CallOptions& common, const nb::object& progress, const Work& work) {
  bool raised = false;
  double reported = 0;  // rows that are done side by side may report out of order
  {
    const nb::gil_scoped_release unlocked;
    WatchedWork watched(common, work);
    while (!watched.wait()) {
      if (raised) continue;
      const nb::gil_scoped_acquire locked;
      reported = std::max(reported, watched.fraction());
      raised = !look(progress, reported);
      if (raised) watched.stop();
    }
    if (!raised) watched.rethrow();
  }
  if (raised || !look(progress, 1)) throw nb::python_error();
}

std::size_t vertices_of(const Operands& operands) {
  std::size_t vertices = 0;
  for (const Arrays* operand : operands) vertices += operand->points.size();
  return vertices;
}

const char* name_of(ErrorCode code) {
  constexpr const char* names[] = {"not_finite",   "out_of_domain", "too_large",    "bad_offsets", "bad_option",
                                   "precondition", "cancelled",     "memory_limit", "bad_wkt",     "bad_wkb"};
  return names[static_cast<int>(code)];
}

nb::object index_or_none(std::size_t index) { return index == Place::npos ? nb::none() : nb::object(nb::int_(index)); }

}  // namespace

int usable_threads(int threads) { return was_forked ? 1 : threads; }

void raise_error(const Error& error, const Operands& operands, std::size_t row) {
  const Place& place = error.place();
  const std::size_t operand = place.operand == Place::npos && operands.size() == 1 ? 0 : place.operand;
  if (row == Place::npos && place.contour != Place::npos && operand < operands.size())
    row = operands[operand]->row_of_ring(place.contour);
  nb::dict places;
  places["operand"] = index_or_none(operand);
  places["row"] = index_or_none(row);
  places["polygon"] = index_or_none(place.polygon);
  places["ring"] = index_or_none(place.contour);
  places["vertex"] = index_or_none(place.vertex);
  places["byte"] = index_or_none(place.byte);
  const nb::object type = nb::module_::import_("oblast._errors").attr("OblastError");
  const nb::object raised = type(error.what(), name_of(error.code()), **places);
  PyErr_SetObject(type.ptr(), raised.ptr());
  throw nb::python_error();
}

void run(const Settings& settings, const Operands& operands, const Work& work, bool quick) {
  CallOptions common = settings.options;
  common.threads = usable_threads(common.threads);
  const bool signals = !quick && on_main_thread() && vertices_of(operands) >= least_watched_vertices;
  std::optional<Error> error;
  try {
    if (signals || !settings.progress.is_none()) {
      run_watched(common, settings.progress, work);
    } else {
      const nb::gil_scoped_release unlocked;
      work(common);
    }
  } catch (const Error& thrown) {
    error = thrown;
  }
  if (error) raise_error(*error, operands);
}

void note_forks() {
  pthread_atfork(nullptr, nullptr, [] { was_forked = true; });
}

}  // namespace oblast::python
