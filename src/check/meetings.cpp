#include "check/meetings.h"

#include <functional>

#include "base/parallel.h"
#include "check/strands_of.h"
#include "exact/intersection_point.h"
#include "exact/orientation.h"
#include "noding/edge_pairs.h"
#include "noding/monotone_runs.h"
#include "noding/pair_finder.h"

namespace oblast::internal::checking {
namespace {

using exact::orientation;
using noding::Strands;

/// Looks at two edges, from several threads at once.
class MeetingCheck {
 public:
  explicit MeetingCheck(Strands& strands) : strands_(strands), points_(strands.points.data()) {}

  //        d                 a, b: ends of edge i;  c, d: ends of edge j
  //   a ---+--- b            +: the meeting
  //        c
  void look_at(std::uint32_t i, std::uint32_t j) {
    const Point &a = points_[i], &b = points_[i + 1], &c = points_[j], &d = points_[j + 1];
    if (a == c || a == d || b == c || b == d) return look_at_common_end(i, j);
    const int c_side = orientation(a, b, c), d_side = orientation(a, b, d);
    if (c_side * d_side > 0) return;
    const int a_side = orientation(c, d, a), b_side = orientation(c, d, b);
    if (a_side * b_side > 0) return;
    const Box ab = Box::of(a, b), cd = Box::of(c, d);
    if (c_side == 0 && d_side == 0) {
      // On one line: they overlap where their boxes meet, from an end of one of them on.
      if (ab.meets(cd)) offer(FaultKind::edges_overlap, i, j, ab.contains(c) ? c : ab.contains(d) ? d : a);
    } else if (c_side != 0 && d_side != 0 && a_side != 0 && b_side != 0) {
      offer(FaultKind::edges_cross, i, j, exact::intersection_point(a, b, c, d));
    } else {
      offer(FaultKind::vertex_on_edge, i, j, c_side == 0 ? c : d_side == 0 ? d : a_side == 0 ? a : b);
    }
  }

  const std::optional<Finding>& first() const { return first_.get(); }

 private:
  void look_at_common_end(std::uint32_t i, std::uint32_t j) {
    for (const std::uint32_t p : {i, i + 1}) {
      for (const std::uint32_t q : {j, j + 1}) {
        if (points_[p] != points_[q]) continue;
        if (!same_vertex(p, q)) {
          strands_.add_flag(p, noding::node_flag);
          strands_.add_flag(q, noding::node_flag);
        }
        // The ends that are not common lie in one direction.
        const Point &at = points_[p], &u = points_[i + i + 1 - p], &v = points_[j + j + 1 - q];
        if (lexicographically_less(at, u) == lexicographically_less(at, v) && orientation(at, u, v) == 0)
          offer(FaultKind::edges_overlap, i, j, at);
      }
    }
  }

  /// One index, or the first and the last vertex of one strand.
  bool same_vertex(std::uint32_t p, std::uint32_t q) const {
    if (p == q) return true;
    if (!(strands_.load_flags(p) & strands_.load_flags(q) & noding::closed_flag)) return false;
    return strands_.strand_of(p) == strands_.strand_of(q);
  }

  void offer(FaultKind kind, std::uint32_t i, std::uint32_t j, const Point& at) {
    const std::uint32_t p = vertex_of(strands_, i), q = vertex_of(strands_, j);
    first_.offer({kind, std::min(p, q), std::max(p, q), at});
  }

  Strands& strands_;
  const Point* points_;
  FirstFinding first_;
};

/// A strand with a node begins and ends with one, as the graph requires.
void complete_nodes(Strands& strands) {
  for_ranges(strands.size(), grain(strands.size(), strands.points.size()), [&](std::size_t s, std::size_t end) {
    for (; s < end; ++s) {
      const auto flags = std::span(strands.flags).subspan(strands.begin(s), strands.ends[s] - strands.begin(s));
      const bool has_node =
          std::any_of(flags.begin(), flags.end(), [](std::uint8_t f) { return (f & noding::node_flag) != 0; });
      if (has_node) flags.front() |= noding::node_flag, flags.back() |= noding::node_flag;
    }
  });
}

}  // namespace

std::optional<Finding> find_bad_meeting(Strands& strands) {
  MeetingCheck check(strands);
  const auto visit = [&](std::span<const noding::RunPair> pairs) {
    poll();
    for (const noding::RunPair& pair : pairs)
      noding::for_edge_pairs(strands.points.data(), pair,
                             [&](std::uint32_t i, std::uint32_t j) { check.look_at(i, j); });
  };
  noding::find_pairs(strands.points, noding::monotone_runs(strands, noding::Grouping::none), std::ref(visit));
  if (!check.first()) complete_nodes(strands);
  return check.first();
}

}  // namespace oblast::internal::checking
