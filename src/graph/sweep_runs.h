// Monotone runs of chains, as a sweep from left to right passes them.
//
//                      : sweep line
//     begin --- v --- v:-- v --- end       The edge under the sweep line is looked for from the edge where it was found
//                    ^ :                   last (`found`). The sweep never goes back, so all looks at a run together
//                  found                   cost no more than its length.
//
// `found` is a cache: no answer depends on it. So a comparison may move it, and still be the comparison of an order.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <span>

#include "base/call_memory.h"
#include "exact/orientation.h"

namespace oblast::internal {

/// A lexicographically monotone stretch of a chain, from its smaller end to its larger one.
struct SweepRun {
  std::uint32_t begin;  ///< vertex of the smaller end
  std::uint32_t end;    ///< vertex of the larger end
  std::int32_t step;    ///< from a vertex to the next: 1 when the chain runs to the right, -1 when to the left
  std::uint32_t chain;
  mutable std::uint32_t found = begin;  ///< vertex where the edge begins that was under the sweep line at the last look
};

class SweepRuns {
 public:
  /// Vertices are indices of `points`.
  explicit SweepRuns(std::span<const Point> points) : points_(points) {}

  void add(const SweepRun& run) {
    runs_.push_back(run);
    starts_.push_back(points_[run.begin]);
  }

  std::size_t size() const { return runs_.size(); }
  const SweepRun& operator[](std::uint32_t r) const { return runs_[r]; }
  const Point& start(std::uint32_t r) const { return starts_[r]; }
  const Point& finish(std::uint32_t r) const { return points_[runs_[r].end]; }
  const Point& second(std::uint32_t r) const { return points_[runs_[r].begin + runs_[r].step]; }

  /// True when run r passes below the edge (p, q), just right of p.
  /// REQUIRES: the sweep stands at p, which lies between the ends of the run, and was never further.
  bool is_below(std::uint32_t r, const Point& p, const Point& q) const {
    const std::uint32_t from = edge_under(r, p);
    const Point &a = points_[from], &b = points_[from + runs_[r].step];
    return a == p ? exact::orientation(p, b, q) > 0 : exact::orientation(a, b, p) > 0;
  }

 private:
  /// The vertex where the edge of run r begins that the sweep line through p meets. Moves the cache.
  std::uint32_t edge_under(std::uint32_t r, const Point& p) const {
    const SweepRun& run = runs_[r];
    std::uint32_t next = run.found + run.step;
    while (next != run.end && !lexicographically_less(p, points_[next])) {
      run.found = next;
      next += run.step;
    }
    return run.found;
  }

  std::span<const Point> points_;
  Array<SweepRun> runs_;
  Array<Point> starts_;
};

}  // namespace oblast::internal
