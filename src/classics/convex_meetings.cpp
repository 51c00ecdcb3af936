// The advance of O'Rourke et al. With the current edges P = (p-, p) of A and Q = (q-, q) of B:
//
//        q-                P aims at Q if its head p may still cross Q's line. An edge that aims advances. If
//          \   p-  p       both or neither aim, the edge whose head is outside the other's half-plane advances.
//           \  ---->       If they are collinear in one direction, the edge that ends first advances.
//            q
//
// Every pair of current edges is tested for meetings, including touching ones.
#include "classics/convex_meetings.h"

#include <algorithm>

#include "base/call_memory.h"
#include "classics/clearance.h"
#include "classics/convex_separation.h"
#include "classics/crossing.h"
#include "exact/intersection_point.h"
#include "exact/orientation.h"

namespace oblast::internal::classics {
namespace {

using exact::orientation;

std::uint32_t after(const Ring& ring, std::uint32_t i) { return i + 1 == ring.size() ? 0 : i + 1; }

/// True if p comes before q in the direction of the edge (a, b). REQUIRES: both are on its line.
bool earlier(const Point& p, const Point& q, const Point& a, const Point& b) {
  return lexicographically_less(a, b) ? lexicographically_less(p, q) : lexicographically_less(q, p);
}

}  // namespace

void NodedContour::add_chain(std::size_t k, window::Contours& result) const {
  const std::uint32_t end = nodes[k + 1 == nodes.size() ? 0 : k + 1];
  std::uint32_t i = nodes[k];
  do {
    result.add(points[i]);
    i = i + 1 == points.size() ? 0 : i + 1;
  } while (i != end);
}

void NodedContour::add_chain_backward(std::size_t k, window::Contours& result) const {
  const std::uint32_t end = nodes[k];
  std::uint32_t i = nodes[k + 1 == nodes.size() ? 0 : k + 1];
  do {
    result.add(points[i]);
    i = i == 0 ? static_cast<std::uint32_t>(points.size() - 1) : i - 1;
  } while (i != end);
}

std::uint64_t ConvexMeetings::find() {
  const std::uint64_t most = 2 * (a_.size() + b_.size());
  std::uint64_t a_steps = 0, b_steps = 0;
  for (std::uint32_t i = 0, j = 0; a_steps + b_steps < most;) {
    test_edges(i, j);
    const Point &a = a_.points[i], &b = a_.next(i), &c = b_.points[j], &d = b_.next(j);
    const int cross = turn({a, b}, {c, d}), b_side = orientation(c, d, b), d_side = orientation(a, b, d);
    bool advance_a;
    if (cross == 0 && b_side == 0 && d_side == 0)
      advance_a = earlier(b, d, a, b);
    else if (cross == 0 && b_side < 0 && d_side < 0)
      break;  // parallel, each outside the other: apart
    else
      advance_a = cross >= 0 ? d_side > 0 : b_side <= 0;
    if (a_steps >= 2 * a_.size() || b_steps >= 2 * b_.size()) break;
    if (advance_a) {
      i = after(a_, i);
      ++a_steps;
    } else {
      j = after(b_, j);
      ++b_steps;
    }
    if (a_steps >= a_.size() && b_steps >= b_.size()) {
      test_edges(i, j);
      break;
    }
  }
  collapsed_ |= !cut(a_, cuts_a_, noded_a_);
  collapsed_ |= !cut(b_, cuts_b_, noded_b_);
  return a_steps + b_steps;
}

//        d                 a, b: ends of edge i of A;  c, d: ends of edge j of B
//   a ---+--- b            +: the meeting
//        c
void ConvexMeetings::test_edges(std::uint32_t i, std::uint32_t j) {
  const Point &a = a_.points[i], &b = a_.next(i), &c = b_.points[j], &d = b_.next(j);
  const int c_side = orientation(a, b, c), d_side = orientation(a, b, d);
  if (c_side * d_side > 0) return;
  const int a_side = orientation(c, d, a), b_side = orientation(c, d, b);
  if (a_side * b_side > 0) return;
  if (c_side * d_side < 0 && a_side * b_side < 0) {
    const Point x = exact::intersection_point(a, b, c, d);
    collapsed_ |= x == a || x == b || x == c || x == d;
    cuts_a_.push_back({i, x, true});
    cuts_b_.push_back({j, x, true});
    return;
  }
  if (c_side == 0) vertex_on_edge(c, a_, i, cuts_a_);
  if (d_side == 0) vertex_on_edge(d, a_, i, cuts_a_);
  if (a_side == 0) vertex_on_edge(a, b_, j, cuts_b_);
  if (b_side == 0) vertex_on_edge(b, b_, j, cuts_b_);
}

/// REQUIRES: p is collinear with the edge.
void ConvexMeetings::vertex_on_edge(const Point& p, const Ring& ring, std::uint32_t edge, Array<Cut>& cuts) {
  const Point &a = ring.points[edge], &b = ring.next(edge);
  if (earlier(a, p, a, b) && earlier(p, b, a, b)) cuts.push_back({edge, p, false});
}

/// False if two different cuts were rounded to the same point.
bool ConvexMeetings::cut(const Ring& ring, Array<Cut>& cuts, NodedContour& noded) {
  // Rounding is monotone, so rounded points keep their order along the edge in each coordinate.
  std::sort(cuts.begin(), cuts.end(), [&](const Cut& p, const Cut& q) {
    if (p.edge != q.edge) return p.edge < q.edge;
    const Point &a = ring.points[p.edge], &b = ring.next(p.edge);
    if (p.at.x != q.at.x) return (p.at.x < q.at.x) == (a.x < b.x);
    if (p.at.y != q.at.y) return (p.at.y < q.at.y) == (a.y < b.y);
    return p.rounded < q.rounded;
  });
  bool distinct = true;
  std::size_t next = 0;
  noded.points.reserve(ring.size() + cuts.size());
  for (std::uint32_t v = 0; v < ring.size(); ++v) {
    noded.points.push_back(ring.points[v]);
    noded.rounded.push_back(false);
    for (; next < cuts.size() && cuts[next].edge == v; ++next) {
      if (cuts[next].at == noded.points.back()) {  // found twice, or collapsed
        distinct &= noded.rounded.back() == cuts[next].rounded;
        continue;
      }
      noded.points.push_back(cuts[next].at);
      noded.rounded.push_back(cuts[next].rounded);
    }
  }
  return distinct;
}

bool ConvexMeetings::pieces_are_clear() const {
  noding::Strands strands;
  const auto add = [&](const NodedContour& contour, noding::Winding change) {
    const std::size_t n = contour.points.size();
    for (std::size_t i = 0; i <= n; ++i) {
      const std::size_t v = i == n ? 0 : i, w = v + 1 == n ? 0 : v + 1;
      const bool moved = i < n && (contour.rounded[v] || contour.rounded[w]);
      strands.points.push_back(contour.points[v]);
      strands.flags.push_back(
          static_cast<std::uint8_t>((contour.rounded[v] ? noding::added_flag : 0) | (moved ? noding::moved_flag : 0)));
    }
    strands.close_strand(change, noding::any_group);
  };
  add(noded_a_, {1, 0});
  add(noded_b_, {0, 1});
  return is_clear(strands);
}

ConvexMeetings::Order ConvexMeetings::settled_order() {
  Array<bool> common_a, common_b;
  if (collapsed_ || !separated(noded_a_.points, noded_b_.points, common_a, common_b)) return Order::unsettled;
  auto &nodes_a = noded_a_.nodes, &nodes_b = noded_b_.nodes;
  for (std::uint32_t v = 0; v < common_a.size(); ++v)
    if (common_a[v]) nodes_a.push_back(v);
  for (std::uint32_t v = 0; v < common_b.size(); ++v)
    if (common_b[v]) nodes_b.push_back(v);
  const std::size_t m = nodes_a.size();
  if (nodes_b.size() != m) return Order::unsettled;
  const bool any_rounded = std::find(noded_a_.rounded.begin(), noded_a_.rounded.end(), true) != noded_a_.rounded.end();
  if (any_rounded && !pieces_are_clear()) return Order::unsettled;
  if (m == 0) return Order::same;

  // Rotate B's list: it must begin, or in opposite order end, with A's first node.
  const auto at_b = [&](std::size_t k) -> const Point& { return noded_b_.points[nodes_b[k]]; };
  const auto at_a = [&](std::size_t k) -> const Point& { return noded_a_.points[nodes_a[k]]; };
  const auto lines_up = [&](bool opposite) {
    for (std::size_t k = 0; k < m; ++k)
      if (at_a(k) != at_b(opposite ? m - 1 - k : k)) return false;
    return true;
  };
  std::size_t first = 0;
  while (first < m && at_b(first) != at_a(0)) ++first;
  if (first == m) return Order::unsettled;
  std::rotate(nodes_b.begin(), nodes_b.begin() + static_cast<std::ptrdiff_t>(first), nodes_b.end());
  if (lines_up(false)) return Order::same;
  std::rotate(nodes_b.begin(), nodes_b.begin() + 1, nodes_b.end());
  return lines_up(true) ? Order::opposite : Order::unsettled;
}

}  // namespace oblast::internal::classics
