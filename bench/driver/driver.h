// The harness of every C++ driver. bench/README.md describes the arguments and the output of a driver.
//
// A peer is a class:
//
//   struct Peer {
//     static std::string name();
//     static std::string version();
//     explicit Peer(const Settings&);                                  // the operation, threads, ...
//     struct Prepared;                                                 // both operands in its own types
//     Prepared prepare(const RegionView& a, const RegionView& b);      // not timed
//     void run(const Prepared&, RegionSet& result);                    // timed: overlay and extraction
//   };
//
// `run` fills an empty result. It may throw; Unsupported means that the peer does not claim to support the workload.
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "driver/report.h"
#include "workloads/workload_file.h"

namespace oblast::bench {

class Unsupported : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

template <class Peer>
class Driver {
 public:
  explicit Driver(const Arguments& arguments) : arguments_(arguments) {
    Workload workload = read_workload(arguments.workload);
    settings_ = settings_for(arguments, workload);
    pairs_ = workload.pairs();
    // With many pairs, every peer works on them with this number of threads, and each call uses one thread.
    if (pairs_ > 1) std::swap(threads_over_pairs_, settings_.threads);
    Peer peer(settings_);
    prepared_.reserve(pairs_);
    for (std::size_t i = 0; i < pairs_; ++i) prepared_.push_back(peer.prepare(workload.a.pair(i), workload.b.pair(i)));
    if constexpr (requires { Peer::keeps_views; }) workload_ = std::move(workload);
  }

  void run() {
    Operand result;
    for (int i = 0; i < arguments_.repeat; ++i) {
      result = {};
      const Memory memory;
      const auto start = std::chrono::steady_clock::now();
      if (pairs_ == 1) {
        run_single(result);
      } else {
        run_pairs(result);
      }
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
      print_run(Peer::name(), Peer::version(), arguments_, seconds.count(), memory, result);
    }
    if (!arguments_.dump.empty()) write_result(arguments_.dump, std::move(result));
  }

 private:
  void run_single(Operand& result) {
    Peer peer(settings_);
    peer.run(prepared_[0], result.arrays);
    if (result.arrays.polygon_ends.empty()) {
      for (std::uint32_t c = 0; c < result.arrays.contour_ends.size(); ++c) {
        result.arrays.polygon_ends.push_back(c + 1);
      }
    }
    result.pair_ends = {
        {result.arrays.points.size(), result.arrays.contour_ends.size(), result.arrays.polygon_ends.size()}};
  }

  void run_pairs(Operand& result) {
    const auto threads = static_cast<std::size_t>(threads_over_pairs_);
    std::vector<Operand> parts(threads);
    std::vector<std::exception_ptr> errors(threads);
    const auto work = [&](std::size_t part) {
      try {
        Peer peer(settings_);
        RegionSet one;
        for (std::size_t i = pairs_ * part / threads; i < pairs_ * (part + 1) / threads; ++i) {
          one.points.clear();
          one.contour_ends.clear();
          one.polygon_ends.clear();
          peer.run(prepared_[i], one);
          parts[part].add(one);
        }
      } catch (...) {
        errors[part] = std::current_exception();
      }
    };
    std::vector<std::thread> workers;
    for (std::size_t part = 1; part < threads; ++part) workers.emplace_back(work, part);
    work(0);
    for (std::thread& worker : workers) worker.join();
    for (const std::exception_ptr& error : errors) {
      if (error) std::rethrow_exception(error);
    }
    result = std::move(parts[0]);
    for (std::size_t part = 1; part < threads; ++part) append(result, parts[part]);
  }

  Arguments arguments_;
  Settings settings_;
  std::size_t pairs_ = 0;
  int threads_over_pairs_ = 1;
  Workload workload_;  // kept only for peers that use views of it
  std::vector<typename Peer::Prepared> prepared_;
};

/// The main function of a driver. Returns 0 if the peer ran, even if it failed on the data (then the line says so).
template <class Peer>
int drive(int argc, char** argv) {
  const std::optional<Arguments> arguments = parse(argc, argv);
  if (!arguments) return 2;
  try {
    Driver<Peer>(*arguments).run();
  } catch (const Unsupported& reason) {
    print_failure(Peer::name(), Peer::version(), *arguments, "unsupported", reason.what());
  } catch (const std::exception& error) {
    print_failure(Peer::name(), Peer::version(), *arguments, "error", error.what());
  }
  return 0;
}

}  // namespace oblast::bench
