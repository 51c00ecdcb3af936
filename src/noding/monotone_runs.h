// Monotone runs: maximal stretches of a strand along which neither coordinate turns back.
//
// A run never meets itself and its box is spanned by its two ends, so the search for meetings starts
// from runs instead of single edges.
#pragma once

#include <algorithm>
#include <cstdint>

#include "base/tuning.h"
#include "memory/large_pages.h"
#include "noding/strands.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace oblast::noding {

struct Box {
  double x0, y0, x1, y1;

  static Box of(const Point& p, const Point& q) {
    return {std::min(p.x, q.x), std::min(p.y, q.y), std::max(p.x, q.x), std::max(p.y, q.y)};
  }
  Box joined(const Box& o) const {
    return {std::min(x0, o.x0), std::min(y0, o.y0), std::max(x1, o.x1), std::max(y1, o.y1)};
  }
  Box joined(const Point& p) const { return joined(of(p, p)); }
  Box widened(double margin) const { return {x0 - margin, y0 - margin, x1 + margin, y1 + margin}; }
  bool contains(const Point& p) const { return x0 <= p.x && p.x <= x1 && y0 <= p.y && p.y <= y1; }
  /// Without a branch: the outcome is hard to foresee.
  bool meets(const Box& o) const {
    return static_cast<bool>(static_cast<int>(x0 <= o.x1) & static_cast<int>(o.x0 <= x1) &
                             static_cast<int>(y0 <= o.y1) & static_cast<int>(o.y0 <= y1));
  }
};

/// Where an edge points: right, up, left, down, a bit each.
inline unsigned heading(const Point& p, const Point& q) {
#ifdef __SSE2__
  const __m128d from = _mm_loadu_pd(&p.x), to = _mm_loadu_pd(&q.x);
  return static_cast<unsigned>(_mm_movemask_pd(_mm_cmpgt_pd(to, from)) | _mm_movemask_pd(_mm_cmplt_pd(to, from)) << 2);
#else
  return static_cast<unsigned>(q.x > p.x) | static_cast<unsigned>(q.y > p.y) << 1 |
         static_cast<unsigned>(q.x < p.x) << 2 | static_cast<unsigned>(q.y < p.y) << 3;
#endif
}

/// Edges of a run at most.
inline constexpr std::uint32_t longest_run = tuning::longest_run;

struct Run {
  Box box;
  std::uint32_t first;  ///< first edge
  std::uint32_t last;   ///< past the last edge, which is also the index of the last vertex
  Group group;
  /// 1 where its strand gets on, in x or in y, from the edge before to its first: the run meets the one before, then,
  /// nowhere but in the vertex between them. A whole word, for runs are copied much.
  std::uint32_t gets_on = 0;
};

/// Which groups the runs of a round get.
enum class Grouping {
  by_strand,  ///< first round: the group of the strand
  none,       ///< first round: all may meet all
  by_moved,   ///< later rounds: pieces made by the last round may meet anything, all others are settled
};

/// A strand gets on where it does so by more than `margin` on either side of the vertex. Cost: linear.
LargeArray<Run> monotone_runs(const Strands& strands, Grouping grouping, double margin = 0);

}  // namespace oblast::noding
