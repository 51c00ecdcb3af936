#include "noding/meetings.h"

#include <oblast/domain.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/index.h"
#include "base/large_pages.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "exact/expansion.h"
#include "exact/intersection_point.h"
#include "exact/orientation.h"
#include "noding/arrange_cuts.h"
#include "noding/clearance.h"
#include "noding/edge_pairs.h"
#include "noding/pair_finder.h"
#include "plane/largest_ulp.h"
#include "plane/point_hash.h"

namespace oblast::internal::noding {
namespace {

using exact::orientation;

constexpr std::uint32_t no_vertex = 0xffffffff;

/// The nearest multiple of `unit` in [low, high].
double round_to_multiple(double value, double unit, double low, double high) {
  const double rounded = std::nearbyint(value / unit) * unit;
  return std::clamp(in_domain(rounded) ? rounded + 0.0 : 0.0, low, high);
}

/// The unit in the last place of the largest coordinate of two edges.
double largest_ulp(const std::array<Point, 4>& ends) { return ulp_of(largest_coordinate(ends)); }

/// x, where (a, b) and (c, d) cross, as a multiple of the unit in the boxes of both.
Point round_further(const Point& x, const Point& a, const Point& b, const Point& c, const Point& d, double unit) {
  const Box p = Box::of(a, b), q = Box::of(c, d);
  return {round_to_multiple(x.x, unit, std::max(p.x0, q.x0), std::min(p.x1, q.x1)),
          round_to_multiple(x.y, unit, std::max(p.y0, q.y0), std::min(p.y1, q.y1))};
}

/// Distance of p from the line (a, b), the same bits for (b, a).
double distance_from_line(const Point& p, Point a, Point b) {
  if (lexicographically_less(b, a)) std::swap(a, b);
  using exact::difference;
  const auto cross = difference(b.x, a.x) * difference(p.y, a.y) - difference(b.y, a.y) * difference(p.x, a.x);
  // Not std::hypot, whose last bit differs between C libraries. In the domain no square under- or overflows.
  const double dx = b.x - a.x, dy = b.y - a.y;
  return std::fabs(cross.estimate()) / std::sqrt(dx * dx + dy * dy);
}

/// Remembers pairs of edges that were looked at a short while ago: cells that lie beside each other bring up the same
/// ones. It forgets, so a pair may still be looked at again, which does no harm.
class RecentPairs {
 public:
  void prepare() {
    if (slots_.empty()) slots_.assign(slot_count, 0);
  }
  /// False when the pair is remembered.
  bool add(std::uint32_t i, std::uint32_t j) {
    if (slots_.empty()) return true;
    const std::uint64_t pair = static_cast<std::uint64_t>(std::min(i, j)) << 32 | std::max(i, j);
    return std::exchange(slots_[mix(pair) % slot_count], pair) != pair;
  }

 private:
  static constexpr std::size_t slot_count = tuning::recent_pairs;
  Array<std::uint64_t> slots_;  // no pair is 0: its edges would be the same
};

/// Cuts of all threads, counted by blocks, so that too many are noticed before they fill the memory.
class CutCount {
 public:
  void add(std::size_t cuts) { check_count(count_.fetch_add(cuts, std::memory_order_relaxed) + cuts, "cuts"); }

 private:
  std::atomic<std::size_t> count_ = 0;
};

/// Cuts as they are found. In blocks, which are not copied as they become many.
class CutList {
 public:
  void push_back(const EdgeCut& cut, CutCount& all) {
    if (blocks_.empty() || blocks_.back().size() == block_size) {
      if (!blocks_.empty()) all.add(block_size);
      blocks_.emplace_back();
      blocks_.back().reserve(blocks_.size() > 1 ? block_size : first_reserve);
    }
    blocks_.back().push_back(cut);
  }
  std::span<const Array<EdgeCut>> blocks() const { return blocks_; }

 private:
  static constexpr std::size_t block_size = tuning::cuts_a_block, first_reserve = tuning::first_cuts;
  Array<Array<EdgeCut>> blocks_;
};

/// What one thread found.
struct Found {
  CutList cuts;
  FirstFindings first;  ///< tangled strands repeatedly
  RecentPairs recent;
};

/// Tests pairs of edges and gathers what they ask for; one a thread.
class MeetingTest {
 public:
  MeetingTest(Strands& strands, Settling settling, Found& found, CutCount& cut_count, Clearance* clearance,
              const FirstFindings* first)
      : strands_(strands),
        points_(strands.points.data()),
        settling_(settling),
        cuts_(found.cuts),
        cut_count_(cut_count),
        recent_(found.recent),
        clearance_(clearance),
        distance_(clearance ? clearance->distance() : std::numeric_limits<double>::infinity()),
        first_(found.first),
        seeks_identical_(first && first->seeks_identical),
        seeks_tangled_(first && first->seeks_tangled) {}

  void test_runs(const RunPair& pair) {
    for_edge_pairs(points_, pair, [this](std::uint32_t i, std::uint32_t j) { test_edges(i, j); });
  }

 private:
  //        d                 a, b: ends of edge i;  c, d: ends of edge j
  //   a ---+--- b            +: the meeting
  //        c
  void test_edges(std::uint32_t i, std::uint32_t j) {
    met_ = false;
    look_at(i, j);
    if (met_ && seeks_tangled_) note_tangled(i, j);
  }

  /// A contour assumed to be simple is not if edges of it meet.
  void note_tangled(std::uint32_t i, std::uint32_t j) {
    const std::size_t strand = strands_.strand_of(i);
    if (strands_.simplicity[strand] == Simplicity::known || j < strands_.begin(strand) || j >= strands_.ends[strand])
      return;
    first_.tangled.push_back(static_cast<std::uint32_t>(strand));
  }

  void look_at(std::uint32_t i, std::uint32_t j) {
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
  bool test_clearly(std::uint32_t i, std::uint32_t j, const Point& a, const Point& b, const Point& c, const Point& d) {
    const auto area = [](const Point& p, const Point& q, const Point& r) {
      return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    };
    const auto length_bound = [](const Point& p, const Point& q) {
      return std::fabs(q.x - p.x) + std::fabs(q.y - p.y);
    };
    const double ab = length_bound(a, b), near_ab = distance_ * ab;
    const double c_area = area(a, b, c), d_area = area(a, b, d);
    const bool ab_clear = std::fabs(c_area) > near_ab && std::fabs(d_area) > near_ab;
    if (ab_clear && (c_area > 0) == (d_area > 0)) return true;
    const double cd = length_bound(c, d), near_cd = distance_ * cd;
    const double a_area = area(c, d, a), b_area = area(c, d, b);
    const bool cd_clear = std::fabs(a_area) > near_cd && std::fabs(b_area) > near_cd;
    if (cd_clear && (a_area > 0) == (b_area > 0)) return true;
    if (!ab_clear || !cd_clear) {
      clearance_->flag(i);
      clearance_->flag(j);
      return false;
    }
    if (!recent_.add(i, j)) return true;
    // d - c, seen from the line (a, b): its length times the sine.
    const auto sine = static_cast<float>(std::fabs(d_area - c_area) / (ab * cd) * (1 - 0x1p-20));
    const Point x = exact::intersection_point(a, b, c, d);
    cut(i, sine, x);
    cut(j, sine, x);
    return true;
  }

  /// The edges meet at the common end, and elsewhere only if they overlap.
  void test_edges_with_common_end(std::uint32_t i, std::uint32_t j) {
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
          if (clearance_) touch_clearly(i, j, points_[p], points_[i + i + 1 - p], points_[j + j + 1 - q]);
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
  void cross(std::uint32_t i, std::uint32_t j) {
    const Point &a = points_[i], &b = points_[i + 1], &c = points_[j], &d = points_[j + 1];
    if (settling_.tolerance > 0 && settle_at_an_end(i, j)) return;
    Point x = exact::intersection_point(a, b, c, d);
    if (settling_.doublings >= 0)
      x = round_further(x, a, b, c, d, std::ldexp(largest_ulp({a, b, c, d}), settling_.doublings));
    meet_at(i, x);
    meet_at(j, x);
  }

  /// Lets one of two crossing edges pass through the nearest end of the other, if that is near enough and
  /// in its box. Of ends equally near, the smallest.
  bool settle_at_an_end(std::uint32_t i, std::uint32_t j) {
    double nearest = settling_.tolerance * largest_ulp({points_[i], points_[i + 1], points_[j], points_[j + 1]});
    std::uint32_t vertex = no_vertex, edge = 0;
    const auto consider = [&](std::uint32_t v, std::uint32_t other) {
      const Point &p = points_[v], &a = points_[other], &b = points_[other + 1];
      if (!Box::of(a, b).contains(p)) return;
      const double distance = distance_from_line(p, a, b);
      if (distance > nearest) return;
      if (vertex != no_vertex && distance == nearest && !lexicographically_less(p, points_[vertex])) return;
      nearest = distance;
      vertex = v;
      edge = other;
    };
    for (const std::uint32_t v : {i, i + 1}) consider(v, j);
    for (const std::uint32_t v : {j, j + 1}) consider(v, i);
    if (vertex == no_vertex) return false;
    mark(vertex);
    cut(edge, 0, points_[vertex]);
    return true;
  }

  /// Edges that follow one another and fold back:  u --- v === tip. The tip is a node, so that the
  /// two pieces that coincide end there. REQUIRES: collinear.
  void mark_fold(std::uint32_t p, const Point& p_tip, const Point& u, std::uint32_t q, const Point& q_tip,
                 const Point& v) {
    if (p_tip != q_tip || lexicographically_less(u, p_tip) != lexicographically_less(v, q_tip)) return;
    mark(p);
    mark(q);
  }

  /// Edge `edge` passes through x: a new vertex, or one of its ends.
  void meet_at(std::uint32_t edge, const Point& x) {
    if (x == points_[edge])
      mark(edge);
    else if (x == points_[edge + 1])
      mark(edge + 1);
    else
      cut(edge, 0, x);
  }

  /// REQUIRES: p, the point of `vertex`, is collinear with the edge.
  void vertex_on_edge(std::uint32_t vertex, const Point& p, std::uint32_t edge) {
    const Point &a = points_[edge], &b = points_[edge + 1];
    if (p == a || p == b) {
      const std::uint32_t other = p == a ? edge : edge + 1;
      if (same_vertex(vertex, other)) return;
      mark(vertex);
      mark(other);
    } else if (Box::of(a, b).contains(p)) {
      mark(vertex);
      cut(edge, 0, p);
    }
  }

  /// One index, or the first and the last vertex of one closed strand.
  bool same_vertex(std::uint32_t p, std::uint32_t q) const {
    if (p == q) return true;
    if (!(strands_.load_flags(p) & strands_.load_flags(q) & closed_flag)) return false;
    return strands_.strand_of(p) == strands_.strand_of(q);
  }

  /// Leaves records of the common end p, which arrange() reads and drops.
  void touch_clearly(std::uint32_t i, std::uint32_t j, const Point& p, const Point& u, const Point& v) {
    const float sine = clearance_->sine_at(p, u, v);
    if (sine == 0) {
      clearance_->flag(i);
      clearance_->flag(j);
      return;
    }
    cut(i, sine, p);
    cut(j, sine, p);
  }

  void mark(std::uint32_t vertex) {
    met_ = true;
    strands_.add_flag(vertex, node_flag);
  }
  void cut(std::uint32_t edge, float sine, const Point& at) {
    met_ = true;
    cuts_.push_back({edge, sine, at}, cut_count_);
  }

  Strands& strands_;
  const Point* points_;
  Settling settling_;
  CutList& cuts_;
  CutCount& cut_count_;
  RecentPairs& recent_;
  Clearance* clearance_;
  double distance_;
  FirstFindings& first_;
  bool seeks_identical_, seeks_tangled_;
  bool met_ = false;  ///< the two edges looked at meet
};

/// Whether two vertices of the strand that are nodes lie at one place.
bool touches_itself(const Strands& strands, std::size_t strand) {
  Array<Point> nodes;
  for (std::uint32_t v = strands.begin(strand); v + 1 < strands.ends[strand]; ++v)
    if (strands.flags[v] & node_flag) nodes.push_back(strands.points[v]);
  std::sort(nodes.begin(), nodes.end(), lexicographically_less);
  return std::adjacent_find(nodes.begin(), nodes.end()) != nodes.end();
}

/// Adds the strands that touch themselves. Where edges of others go through the same vertex, the search need not visit
/// the two edges of the strand together (pair_finder.h); but both its vertices there are nodes.
void add_touching(const Strands& strands, Array<std::uint32_t>& tangled) {
  Array<std::uint8_t> found(strands.size(), 0);
  for_ranges(strands.size(), grain(strands.size(), strands.points.size()), [&](std::size_t first, std::size_t past) {
    for (; first < past; ++first)
      found[first] = strands.simplicity[first] == Simplicity::assumed && touches_itself(strands, first);
  });
  for (std::uint32_t s = 0; s < strands.size(); ++s)
    if (found[s]) tangled.push_back(s);
}

}  // namespace

LargeArray<EdgeCut> find_meetings(Strands& strands, Grouping grouping, Settling settling,
                                  const std::function<void()>& checkpoint, Clearance* clearance, FirstFindings* first) {
  LargeArray<Run> runs = monotone_runs(strands, grouping, clearance ? clearance->run_margins() : RunMargins{});
  const bool repeats = runs.size() > runs_of_one_cell, parallel = runs.size() > runs_of_one_thread;
  Found by_caller;
  CutCount cut_count;
  std::optional<PerThread<Found>> by_thread;
  if (parallel) by_thread.emplace();
  const auto visit = [&](std::span<const RunPair> pairs) {
    if (checkpoint) checkpoint();
    Found& mine = by_thread ? by_thread->local() : by_caller;
    if (repeats) mine.recent.prepare();
    MeetingTest test(strands, settling, mine, cut_count, clearance, first);
    for (const RunPair& pair : pairs) test.test_runs(pair);
  };
  UnsureEdge unsure;
  if (clearance) unsure = [clearance](std::uint32_t edge) { clearance->flag(edge); };
  find_pairs(strands.points, std::move(runs), std::ref(visit), PairGoal::meetings, unsure);
  Array<Found> by_threads;
  if (by_thread)
    for (Found& part : *by_thread) by_threads.push_back(std::move(part));
  const std::span<const Found> found = by_thread ? std::span<const Found>(by_threads) : std::span(&by_caller, 1);
  if (first) {
    Array<std::uint32_t>& tangled = first->tangled;
    for (const Found& part : found) {
      tangled.insert(tangled.end(), part.first.tangled.begin(), part.first.tangled.end());
      first->identical |= part.first.identical;
    }
    if (first->seeks_tangled) add_touching(strands, tangled);
    std::sort(tangled.begin(), tangled.end());
    tangled.erase(std::unique(tangled.begin(), tangled.end()), tangled.end());
    if (first->asks_for_change()) return {};
  }
  Array<std::span<const EdgeCut>> blocks;
  for (const Found& part : found)
    for (const auto& block : part.cuts.blocks()) blocks.emplace_back(block);
  if (blocks.empty()) return {};
  LargeArray<EdgeCut> cuts = arrange_cuts(strands, blocks, settling, clearance);
  if (!clearance)
    for (const EdgeCut& cut : cuts) strands.flags[cut.edge] |= near_flag;
  return cuts;
}

}  // namespace oblast::internal::noding
