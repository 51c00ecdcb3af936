// Lee's linear-time hull of a simple polygon, as in Preparata and Shamos, section 4.1.4.
//
// Idea: the smallest vertex p1 and the largest vertex pM divide the clockwise ring into two chains. Described here is
// the walk along the upper chain, from p1 to pM. The lower chain is the same walk from pM to p1, rotated by 180
// degrees. A counter-clockwise ring is walked in a mirror: left and right are exchanged. A stack has the critical
// vertices q1 = p1, q2, .., qi. The edge q(i-1) qi is the lid of a pocket, which is the boundary between the two. The
// vertex v that follows qi on the boundary lies in one of four regions:
//
//                    (3)                     u: the vertex before qi on the boundary
//        q(i-1) =====lid===== qi             (1) in the pocket: continue until the boundary comes out
//          |   (1)          / | `-._             through the lid; that vertex is in (3)
//          |  pocket .----u   |(2)  `-._     (2) right of the lid, above qi pM: a critical vertex
//           `-------'      (4)          pM   (3) left of the lid: remove the lids it can see; then critical
//                                            (4) below qi pM: continue until the boundary comes up again
//
// The ring is simple, so the boundary can leave a pocket only through its lid (Jordan). Sklansky's scan of 1972 does
// not have the regions (1) and (4), and fails there.
#include "hull/lee.h"

#include <algorithm>
#include <cassert>

#include "base/call_memory.h"
#include "base/parallel.h"
#include "exact/orientation.h"

namespace oblast::internal {
namespace {

/// Walks a chain of a ring by its indices.
class Walk {
 public:
  Walk(std::span<const Point> ring, std::size_t first, std::size_t last) : ring_(ring), at_(first), last_(last) {}

  bool at_end() const { return at_ == last_; }
  const Point& step() {
    at_ = at_ + 1 == ring_.size() ? 0 : at_ + 1;
    return ring_[at_];
  }
  const Point& here() const { return ring_[at_]; }
  const Point& before() const { return ring_[at_ == 0 ? ring_.size() - 1 : at_ - 1]; }

 private:
  std::span<const Point> ring_;
  std::size_t at_, last_;
};

/// True if v is beyond q. REQUIRES: v is on the line (p, q).
bool beyond(const Point& p, const Point& q, const Point& v) {
  return lexicographically_less(p, q) == lexicographically_less(q, v);
}

/// Appends the hull of one chain, without its last vertex. `mirror`: 1 for a clockwise ring, -1 for a counter-clockwise
/// one.
template <int mirror>
void append_chain_hull(std::span<const Point> ring, std::size_t first, std::size_t last, Array<Point>& hull) {
  const auto orientation = [](const Point& a, const Point& b, const Point& c) {
    return mirror * exact::orientation(a, b, c);
  };
  const std::size_t bottom = hull.size();
  const Point p_m = ring[last];
  hull.push_back(ring[first]);
  Walk walk(ring, first, last);
  while (!walk.at_end()) {
    // The walk is at the vertex qi; u is the vertex before it.
    const Point u = walk.before(), qi = walk.here();
    Point v = walk.step();
    bool left_of_lid = false;
    if (hull.size() - bottom > 1) {
      const Point& q_below = hull[hull.size() - 2];
      const int side = orientation(q_below, qi, v);
      left_of_lid = side > 0 || (side == 0 && beyond(q_below, qi, v));
      const bool in_pocket = !left_of_lid && (side == 0 || orientation(u, qi, v) > 0);
      if (in_pocket) {  // region 1
        while (!walk.at_end() && orientation(q_below, qi, v) <= 0) v = walk.step();
        left_of_lid = true;
      }
    }
    if (!left_of_lid)  // region 4, or none to skip in region 2
      while (!walk.at_end() && orientation(qi, p_m, v) < 0) v = walk.step();
    while (hull.size() - bottom > 1 && orientation(hull[hull.size() - 2], hull.back(), v) >= 0)
      hull.pop_back();  // region 3
    hull.push_back(v);
  }
  hull.pop_back();
}

}  // namespace

Array<Point> lee_hull(std::span<const Point> ring, int direction) {
  assert(ring.size() >= 3);
  const auto [smallest, largest] = std::minmax_element(ring.begin(), ring.end(), lexicographically_less);
  const auto p_1 = static_cast<std::size_t>(smallest - ring.begin());
  const auto p_m = static_cast<std::size_t>(largest - ring.begin());
  Array<Point> hull;
  const auto append = direction > 0 ? append_chain_hull<-1> : append_chain_hull<1>;
  append(ring, p_1, p_m, hull);
  append(ring, p_m, p_1, hull);
  if (direction < 0) std::reverse(hull.begin() + 1, hull.end());
  return hull;
}

Array<Point> monotone_chain_hull(Array<Point>& points) {
  parallel_sort(points.begin(), points.end(), lexicographically_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Array<Point> hull;
  const auto add = [&](const Point& p, std::size_t bottom) {
    while (hull.size() > bottom && exact::orientation(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
    hull.push_back(p);
  };
  for (const Point& p : points) add(p, 1);
  const std::size_t bottom = hull.size();
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], bottom);
  hull.pop_back();
  return hull;
}

}  // namespace oblast::internal
