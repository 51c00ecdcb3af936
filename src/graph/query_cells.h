// Which queries may lie between two values of x: counted by cells of equal width.
//
//   queries      q0 q1 |    | q2 |       in their order, by x
//   cells         c0     c1   c2
//   before_      0     2    2    3       edges in c1 hold no query: most edges are like that
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "base/call_memory.h"
#include "base/counting_sort.h"
#include "graph/locate_below.h"

namespace oblast::internal {

class QueryCells {
 public:
  /// Of the queries in `order`, sorted by p.
  QueryCells(std::span<const BelowQuery> queries, std::span<const std::uint32_t> order)
      : count_(4 * order.size()), before_(count_ + 1) {
    low_ = queries[order.front()].p.x;
    const double scale = static_cast<double>(count_) / (queries[order.back()].p.x - low_);
    if (std::isfinite(scale)) scale_ = scale;
    count_begins(before_, [&](const auto& visit) {
      for (const std::uint32_t i : order) visit(cell_of(queries[i].p.x), i);
    });
  }

  /// Places in `order` among which those between two x are.
  std::pair<std::uint32_t, std::uint32_t> between(double x0, double x1) const {
    return {before_[cell_of(x0)], before_[cell_of(x1) + 1]};
  }

 private:
  std::size_t cell_of(double x) const {
    return static_cast<std::size_t>(std::clamp((x - low_) * scale_, 0.0, static_cast<double>(count_ - 1)));
  }

  std::size_t count_;
  double low_, scale_ = 0;
  Array<std::uint32_t> before_;
};

}  // namespace oblast::internal
