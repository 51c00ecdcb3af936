#include "repair/ring_faults.h"

#include <algorithm>
#include <atomic>
#include <functional>

#include "base/parallel.h"
#include "exact/orientation.h"
#include "noding/edge_pairs.h"
#include "noding/monotone_runs.h"
#include "noding/pair_finder.h"
#include "noding/strands.h"
#include "repair/plain_ring.h"

namespace oblast::internal::repairing {
namespace {

using exact::orientation;
using noding::Strands;

/// How two edges meet.
enum class Meeting { none, at_a_point, cross, overlap };

//        d               a, b: ends of one edge;  c, d: ends of the other one
//   a ---+--- b
//        c
Meeting meeting_of(const Point& a, const Point& b, const Point& c, const Point& d) {
  const int c_side = orientation(a, b, c), d_side = orientation(a, b, d);
  if (c_side * d_side > 0) return Meeting::none;
  const int a_side = orientation(c, d, a), b_side = orientation(c, d, b);
  if (a_side * b_side > 0) return Meeting::none;
  if (c_side != 0 || d_side != 0) return c_side * d_side * a_side * b_side != 0 ? Meeting::cross : Meeting::at_a_point;
  // On one line: from the larger of the beginnings to the smaller of the ends, along the line.
  const auto [a0, a1] = std::minmax(a, b, lexicographically_less);
  const auto [c0, c1] = std::minmax(c, d, lexicographically_less);
  const Point &from = lexicographically_less(a0, c0) ? c0 : a0, &to = lexicographically_less(a1, c1) ? a1 : c1;
  if (lexicographically_less(from, to)) return Meeting::overlap;
  return from == to ? Meeting::at_a_point : Meeting::none;
}

class RingFaults {
 public:
  explicit RingFaults(const RegionView& feature) {
    for (std::uint32_t p = 0; p < feature.polygon_count(); ++p)
      for (std::uint32_t c = feature.polygon_begin(p); c < feature.polygon_end(p); ++c) add_ring(feature.contour(c), p);
    strands_.flags.assign(strands_.points.size(), 0);
    for (std::size_t s = 0; s < strands_.size(); ++s)
      strands_.flags[strands_.begin(s)] = strands_.flags[strands_.ends[s] - 1] = noding::closed_flag;
  }

  FaultSet run() {
    if (strands_.size() == 0) return faults_;
    const auto visit = [&](std::span<const noding::RunPair> pairs) {
      poll();
      for (const noding::RunPair& pair : pairs)
        noding::for_edge_pairs(strands_.points.data(), pair, [&](std::uint32_t i, std::uint32_t j) { look_at(i, j); });
    };
    noding::find_pairs(strands_.points, noding::monotone_runs(strands_, noding::Grouping::none), std::ref(visit));
    faults_.add(FaultSet::of_bits(found_.load(std::memory_order_relaxed)));
    // Where a ring runs along itself it also goes through its vertices again.
    if (faults_.has(RepairFault::spike) || faults_.has(RepairFault::ring_repeats_border))
      faults_.remove(RepairFault::ring_meets_itself);
    return faults_;
  }

  std::uint32_t dropped() const { return dropped_; }

 private:
  void add_ring(std::span<const Point> ring, std::uint32_t polygon) {
    const Array<Point> plain = plain_ring(ring);
    // Fewer than three vertices, or one vertex again after another one: two different points.
    const bool few = plain.size() < 3;
    const bool flat = !few && std::all_of(plain.begin() + 2, plain.end(),
                                          [&](const Point& p) { return orientation(plain[0], plain[1], p) == 0; });
    if (few) faults_.add(RepairFault::too_few_points);
    if (flat) faults_.add(RepairFault::no_area);
    if (few || flat) {
      ++dropped_;
      return;
    }
    strands_.points.insert(strands_.points.end(), plain.begin(), plain.end());
    strands_.points.push_back(plain[0]);
    strands_.close_strand({1, 0}, noding::any_group);
    polygon_.push_back(polygon);
  }

  /// One edge follows the other in their ring.
  bool is_next(std::uint32_t i, std::uint32_t j, std::size_t strand) const {
    if (i > j) std::swap(i, j);
    return j == i + 1 || (i == strands_.begin(strand) && j + 2 == strands_.ends[strand]);
  }

  void look_at(std::uint32_t i, std::uint32_t j) {
    const Point* const points = strands_.points.data();
    const Meeting meeting = meeting_of(points[i], points[i + 1], points[j], points[j + 1]);
    if (meeting == Meeting::none) return;
    const std::size_t p = strands_.strand_of(i), q = strands_.strand_of(j);
    if (p == q)
      add_in_one_ring(meeting, is_next(i, j, p));
    else
      add_of_two_rings(meeting, polygon_[p] == polygon_[q]);
  }

  void add_in_one_ring(Meeting meeting, bool next) {
    if (meeting == Meeting::cross) found(RepairFault::ring_crosses_itself);
    if (meeting == Meeting::overlap) found(next ? RepairFault::spike : RepairFault::ring_repeats_border);
    if (meeting == Meeting::at_a_point && !next) found(RepairFault::ring_meets_itself);
  }

  void add_of_two_rings(Meeting meeting, bool one_polygon) {
    if (meeting == Meeting::cross) found(one_polygon ? RepairFault::rings_cross : RepairFault::polygons_overlap);
    if (meeting == Meeting::overlap)
      found(one_polygon ? RepairFault::rings_share_border : RepairFault::polygons_share_border);
  }

  void found(RepairFault fault) {
    const std::uint32_t bit = FaultSet::bit_of(fault);
    if (!(found_.load(std::memory_order_relaxed) & bit)) found_.fetch_or(bit, std::memory_order_relaxed);
  }

  Strands strands_;
  Array<std::uint32_t> polygon_;  ///< by strand
  FaultSet faults_;
  std::atomic<std::uint32_t> found_ = 0;  ///< bits, from several threads
  std::uint32_t dropped_ = 0;
};

}  // namespace

FaultSet find_ring_faults(const RegionView& feature, std::uint32_t& dropped) {
  RingFaults faults(feature);
  const FaultSet found = faults.run();
  dropped = faults.dropped();
  return found;
}

}  // namespace oblast::internal::repairing
