#include "noding/meeting_test.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "exact/intersection_point.h"
#include "exact/orientation.h"
#include "noding/clearance.h"
#include "noding/edge_pairs.h"

namespace oblast::internal::noding {

using exact::orientation;

MeetingTest::MeetingTest(Strands& strands, Settling settling, Found& found, ContactCount& contact_count,
                         Clearance* clearance, const FirstFindings* first)
    : strands_(strands),
      points_(strands.points.data()),
      settling_(settling),
      contacts_(found.contacts),
      contact_count_(contact_count),
      recent_(found.recent),
      clearance_(clearance),
      distance_(clearance ? clearance->distance() : std::numeric_limits<double>::infinity()),
      first_(found.first),
      seeks_identical_(first && first->seeks_identical),
      seeks_tangled_(first && first->seeks_tangled) {}

void MeetingTest::test_runs(const RunPair& pair) {
  for_edge_pairs(points_, pair, [this](std::uint32_t i, std::uint32_t j) { test_edges(i, j); });
}

//        d                 a, b: ends of edge i;  c, d: ends of edge j
//   a ---+--- b            +: the meeting
//        c
void MeetingTest::test_edges(std::uint32_t i, std::uint32_t j) {
  met_ = false;
  look_at(i, j);
  if (met_ && seeks_tangled_) note_tangled(i, j);
}

/// A contour assumed to be simple is not if edges of it meet.
void MeetingTest::note_tangled(std::uint32_t i, std::uint32_t j) {
  const std::size_t strand = strands_.strand_of(i);
  if (strands_.simplicity[strand] == Simplicity::known || j < strands_.begin(strand) || j >= strands_.ends[strand])
    return;
  first_.tangled.push_back(static_cast<std::uint32_t>(strand));
}

void MeetingTest::look_at(std::uint32_t i, std::uint32_t j) {
  const Point &a = points_[i], &b = points_[i + 1], &c = points_[j], &d = points_[j + 1];
  // Most pairs are edges that follow one another, and meet once more only where they are collinear.
  if (j == i + 1 && orientation(a, b, d) != 0) return;
  if (i == j + 1 && orientation(c, d, b) != 0) return;
  // From the second round on nearly all pairs are edges that meet at a node.
  if (a == c || a == d || b == c || b == d) {
    test_edges_with_common_end(i, j);
    return;
  }
  if (clearance_ && test_clearly(i, j, a, b, c, d)) return;
  const int c_side = orientation(a, b, c), d_side = orientation(a, b, d);
  if (c_side * d_side > 0) return;
  if (c_side != 0 && d_side != 0) {
    const int a_side = orientation(c, d, a), b_side = orientation(c, d, b);
    if (a_side * b_side > 0) return;
    if (a_side != 0 && b_side != 0) {
      cross(i, j);
      return;
    }
    if (a_side == 0) vertex_on_edge(i, a, j);
    if (b_side == 0) vertex_on_edge(i + 1, b, j);
    return;
  }
  if (c_side == 0) vertex_on_edge(j, c, i);
  if (d_side == 0) vertex_on_edge(j + 1, d, i);
  // An end of edge i may lie on edge j only where the edges are collinear or an end of j lies there too.
  if (c_side == 0 && d_side == 0) {
    vertex_on_edge(i, a, j);
    vertex_on_edge(i + 1, b, j);
  }
}

/// True when the edges are separate or cross, clearly (clearance.h). Areas are computed from an end of the edge (p,
/// q): their rounding is then in proportion to its length, however far r is, and below a quarter of what is asked
/// for.
bool MeetingTest::test_clearly(std::uint32_t i, std::uint32_t j, const Point& a, const Point& b, const Point& c,
                               const Point& d) {
  const auto area = [](const Point& p, const Point& q, const Point& r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  };
  const auto length_bound = [](const Point& p, const Point& q) { return std::fabs(q.x - p.x) + std::fabs(q.y - p.y); };
  const double ab = length_bound(a, b), near_ab = distance_ * ab;
  const double c_area = area(a, b, c), d_area = area(a, b, d);
  const bool ab_clear = std::fabs(c_area) > near_ab && std::fabs(d_area) > near_ab;
  if (ab_clear && (c_area > 0) == (d_area > 0)) return true;
  const double cd = length_bound(c, d), near_cd = distance_ * cd;
  const double a_area = area(c, d, a), b_area = area(c, d, b);
  const bool cd_clear = std::fabs(a_area) > near_cd && std::fabs(b_area) > near_cd;
  if (cd_clear && (a_area > 0) == (b_area > 0)) return true;
  if (!ab_clear || !cd_clear) {
    flag_both(i, j);
    return false;
  }
  if (!recent_.add(i, j)) return true;
  // d - c, seen from the line (a, b): its length times the sine.
  const auto sine = static_cast<float>(std::fabs(d_area - c_area) / (ab * cd) * (1 - 0x1p-20));
  const Point x = exact::intersection_point(a, b, c, d);
  add_contact(i, sine, x);
  add_contact(j, sine, x);
  return true;
}

/// The edges meet at the common end, and elsewhere only if they overlap.
void MeetingTest::test_edges_with_common_end(std::uint32_t i, std::uint32_t j) {
  if (seeks_identical_) {
    const Point &a = points_[i], &b = points_[i + 1], &c = points_[j], &d = points_[j + 1];
    first_.identical |= (a == c && b == d) || (a == d && b == c);
  }
  for (const std::uint32_t p : {i, i + 1}) {
    for (const std::uint32_t q : {j, j + 1}) {
      if (points_[p] != points_[q]) continue;
      if (!same_vertex(p, q)) {
        mark(p);
        mark(q);
        if (clearance_) note_common_end(i, j, points_[p], points_[i + i + 1 - p], points_[j + j + 1 - q]);
      }
      // The ends that are not common.
      const std::uint32_t u = i + i + 1 - p, v = j + j + 1 - q;
      if (orientation(points_[p], points_[u], points_[v]) != 0) return;
      vertex_on_edge(u, points_[u], j);
      vertex_on_edge(v, points_[v], i);
      mark_fold(p, points_[p], points_[u], q, points_[q], points_[v]);
    }
  }
}

/// Edges i and j cross inside both.
void MeetingTest::cross(std::uint32_t i, std::uint32_t j) {
  const Point &a = points_[i], &b = points_[i + 1], &c = points_[j], &d = points_[j + 1];
  if (settling_.tolerance > 0 && settle_at_an_end(i, j)) return;
  const Point x = new_vertex(settling_, a, b, c, d);
  meet_at(i, x);
  meet_at(j, x);
}

/// Lets one of two crossing edges pass through the nearest end of the other, if that is near enough and
/// in its box. Of ends equally near, the smallest.
bool MeetingTest::settle_at_an_end(std::uint32_t i, std::uint32_t j) {
  double nearest = settling_distance(settling_, {points_[i], points_[i + 1], points_[j], points_[j + 1]});
  std::uint32_t vertex = none, edge = 0;
  const auto consider = [&](std::uint32_t v, std::uint32_t other) {
    const Point &p = points_[v], &a = points_[other], &b = points_[other + 1];
    if (!Box::of(a, b).contains(p)) return;
    const double distance = distance_from_line(p, a, b);
    if (distance > nearest) return;
    if (vertex != none && distance == nearest && !lexicographically_less(p, points_[vertex])) return;
    nearest = distance;
    vertex = v;
    edge = other;
  };
  for (const std::uint32_t v : {i, i + 1}) consider(v, j);
  for (const std::uint32_t v : {j, j + 1}) consider(v, i);
  if (vertex == none) return false;
  mark(vertex);
  add_contact(edge, 0, points_[vertex]);
  return true;
}

/// Edges that follow one another and fold back:  u --- v === tip. The tip is a node, so that the
/// two pieces that coincide end there. REQUIRES: collinear.
void MeetingTest::mark_fold(std::uint32_t p, const Point& p_tip, const Point& u, std::uint32_t q, const Point& q_tip,
                            const Point& v) {
  if (p_tip != q_tip || lexicographically_less(u, p_tip) != lexicographically_less(v, q_tip)) return;
  mark(p);
  mark(q);
}

/// Edge `edge` passes through x: a new vertex, or one of its ends.
void MeetingTest::meet_at(std::uint32_t edge, const Point& x) {
  if (x == points_[edge])
    mark(edge);
  else if (x == points_[edge + 1])
    mark(edge + 1);
  else
    add_contact(edge, 0, x);
}

/// REQUIRES: p, the point of `vertex`, is collinear with the edge.
void MeetingTest::vertex_on_edge(std::uint32_t vertex, const Point& p, std::uint32_t edge) {
  const Point &a = points_[edge], &b = points_[edge + 1];
  if (p == a || p == b) {
    const std::uint32_t other = p == a ? edge : edge + 1;
    if (same_vertex(vertex, other)) return;
    mark(vertex);
    mark(other);
  } else if (Box::of(a, b).contains(p)) {
    mark(vertex);
    add_contact(edge, 0, p);
  }
}

/// One index, or the first and the last vertex of one closed strand.
bool MeetingTest::same_vertex(std::uint32_t p, std::uint32_t q) const {
  if (p == q) return true;
  if (!(strands_.load_flags(p) & strands_.load_flags(q) & closed_flag)) return false;
  return strands_.strand_of(p) == strands_.strand_of(q);
}

/// Both edges end in p: one goes on to u, the other to v.
void MeetingTest::note_common_end(std::uint32_t i, std::uint32_t j, const Point& p, const Point& u, const Point& v) {
  const float sine = clearance_->sine_at(p, u, v);
  if (sine == 0) {
    flag_both(i, j);
    return;
  }
  add_contact(i, sine, p);
  add_contact(j, sine, p);
}

void MeetingTest::flag_both(std::uint32_t i, std::uint32_t j) {
  clearance_->flag(i);
  clearance_->flag(j);
}

}  // namespace oblast::internal::noding
