// The order of points along an edge.
#pragma once

#include <oblast/point.h>

namespace oblast::internal::noding {

/// Whether p comes before q along an edge from a to b, for points in its box of which one is not above and the other
/// beyond: by x, and by y where x is the same, each in the edge's own direction. Rounding is monotone, so cuts of an
/// edge are in this order.
class Along {
 public:
  Along(const Point& a, const Point& b) : rightward_(a.x < b.x), upward_(a.y < b.y) {}

  bool operator()(const Point& p, const Point& q) const {
    if (p.x != q.x) return (p.x < q.x) == rightward_;
    if (p.y != q.y) return (p.y < q.y) == upward_;
    return false;
  }

 private:
  bool rightward_, upward_;
};

}  // namespace oblast::internal::noding
