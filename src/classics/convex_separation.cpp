// Each contour is two lexicographically monotone chains. Two edges can meet only if their ranges in that order overlap.
// For two chains, the number of such pairs of edges is at most the total number of their edges.
#include "classics/convex_separation.h"

#include <algorithm>
#include <array>

#include "base/call_memory.h"
#include "exact/orientation.h"

namespace oblast::internal::classics {
namespace {

using exact::orientation;

/// A chain of a contour, from its smallest to its largest vertex.
struct Chain {
  const Array<Point>* points;
  std::size_t first;
  std::size_t size;  ///< number of vertices
  bool backward;

  std::size_t vertex(std::size_t i) const {
    const std::size_t n = points->size();
    const std::size_t v = backward ? first + n - i : first + i;
    return v >= n ? v - n : v;
  }
  const Point& operator[](std::size_t i) const { return (*points)[vertex(i)]; }
  bool is_monotone() const {
    for (std::size_t i = 0; i + 1 < size; ++i)
      if (!lexicographically_less((*this)[i], (*this)[i + 1])) return false;
    return true;
  }
};

std::array<Chain, 2> chains_of(const Array<Point>& ring) {
  const auto [smallest, largest] = std::minmax_element(ring.begin(), ring.end(), lexicographically_less);
  const auto first = static_cast<std::size_t>(smallest - ring.begin()), n = ring.size();
  const std::size_t length = (static_cast<std::size_t>(largest - ring.begin()) + n - first) % n;
  return {Chain{&ring, first, length + 1, false}, Chain{&ring, first, n - length + 1, true}};
}

bool boxes_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  return std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) &&
         std::max(a.y, b.y) >= std::min(c.y, d.y) && std::max(c.y, d.y) >= std::min(a.y, b.y);
}

/// True if the edges meet other than at one common end, and are not identical. REQUIRES: a < b, c < d.
bool in_conflict(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (!boxes_meet(a, b, c, d)) return false;
  if (a == c || b == d) return (a == c) != (b == d) && orientation(a, b, a == c ? d : c) == 0;
  if (a == d || b == c) return false;  // one follows the other in the order, so they do not overlap
  if (orientation(a, b, c) * orientation(a, b, d) > 0) return false;
  return orientation(c, d, a) * orientation(c, d, b) <= 0;
}

/// A common vertex of both chains is an end of two edges that are compared.
bool separated(const Chain& p, const Chain& q, Array<bool>& common_p, Array<bool>& common_q) {
  for (std::size_t i = 0, j = 0; i + 1 < p.size && j + 1 < q.size;) {
    if (in_conflict(p[i], p[i + 1], q[j], q[j + 1])) return false;
    for (const std::size_t k : {i, i + 1})
      for (const std::size_t l : {j, j + 1})
        if (p[k] == q[l]) common_p[p.vertex(k)] = common_q[q.vertex(l)] = true;
    lexicographically_less(p[i + 1], q[j + 1]) ? ++i : ++j;
  }
  return true;
}

}  // namespace

bool separated(const Array<Point>& a, const Array<Point>& b, Array<bool>& common_a, Array<bool>& common_b) {
  common_a.assign(a.size(), false);
  common_b.assign(b.size(), false);
  for (const Chain& p : chains_of(a)) {
    if (!p.is_monotone()) return false;
    for (const Chain& q : chains_of(b))
      if (!q.is_monotone() || !separated(p, q, common_a, common_b)) return false;
  }
  return true;
}

}  // namespace oblast::internal::classics
