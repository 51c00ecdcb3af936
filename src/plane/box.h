// Boxes with sides along the axes, and the directions of edges.
#pragma once

#include <oblast/point.h>

#include <algorithm>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace oblast::internal {

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
  /// Without a branch, because the outcome is hard to predict.
  bool meets(const Box& o) const {
    return static_cast<bool>(static_cast<int>(x0 <= o.x1) & static_cast<int>(o.x0 <= x1) &
                             static_cast<int>(y0 <= o.y1) & static_cast<int>(o.y0 <= y1));
  }
};

/// The directions of an edge: one bit each for right, up, left, down.
inline unsigned heading(const Point& p, const Point& q) {
#ifdef __SSE2__
  const __m128d from = _mm_loadu_pd(&p.x), to = _mm_loadu_pd(&q.x);
  return static_cast<unsigned>(_mm_movemask_pd(_mm_cmpgt_pd(to, from)) | _mm_movemask_pd(_mm_cmplt_pd(to, from)) << 2);
#else
  return static_cast<unsigned>(q.x > p.x) | static_cast<unsigned>(q.y > p.y) << 1 |
         static_cast<unsigned>(q.x < p.x) << 2 | static_cast<unsigned>(q.y < p.y) << 3;
#endif
}

}  // namespace oblast::internal
