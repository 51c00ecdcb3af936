#include "noding/node.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/call_memory.h"
#include "base/tuning.h"
#include "exact/expansion.h"
#include "noding/clearance.h"
#include "noding/insert_cuts.h"
#include "noding/meetings.h"
#include "noding/monotone_runs.h"

namespace oblast::internal::noding {
namespace {

void flag_closed_strands(Strands& strands) {
  for (std::size_t s = 0; s < strands.size(); ++s) {
    const std::uint32_t first = strands.begin(s), last = strands.ends[s] - 1;
    if (strands.points[first] != strands.points[last]) continue;
    strands.flags[first] |= closed_flag;
    strands.flags[last] |= closed_flag;
  }
}

void flag_strand_ends(Strands& strands) {
  for (std::size_t s = 0; s < strands.size(); ++s) {
    const std::uint32_t first = strands.begin(s), last = strands.ends[s] - 1;
    const auto is_node = [](std::uint8_t flags) { return (flags & node_flag) != 0; };
    const bool closed = (strands.flags[first] & closed_flag) != 0;
    if (closed && std::none_of(strands.flags.begin() + first, strands.flags.begin() + last + 1, is_node)) continue;
    strands.flags[first] |= node_flag;
    strands.flags[last] |= node_flag;
  }
}

/// The distance of p from the line (a, b), by pairs of doubles: a thousandth of a unit in the last place is to be told,
/// and the same on every machine.
double distance_from_line(const Point& p, const Point& a, const Point& b) {
  double dx, dx_low, dy, dy_low, px, px_low, py, py_low;
  exact::two_diff(b.x, a.x, dx, dx_low);
  exact::two_diff(b.y, a.y, dy, dy_low);
  exact::two_diff(p.x, a.x, px, px_low);
  exact::two_diff(p.y, a.y, py, py_low);
  double left, left_low, right, right_low, cross, cross_low;
  exact::two_product(dx, py, left, left_low);
  left_low += dx * py_low + dx_low * py;
  exact::two_product(dy, px, right, right_low);
  right_low += dy * px_low + dy_low * px;
  exact::two_diff(left, right, cross, cross_low);
  cross += cross_low + (left_low - right_low);
  return std::fabs(cross) / std::sqrt(dx * dx + dy * dy);
}

/// How far noding moved the boundary, measured against the edges as they were given.
double displacement(const Strands& noded, const LargeArray<Point>& input) {
  double largest = 0;
  for (std::size_t v = 0; v < noded.points.size(); ++v) {
    if (!(noded.flags[v] & added_flag)) continue;
    const std::uint32_t edge = noded.origin[v];
    largest = std::max(largest, distance_from_line(noded.points[v], input[edge], input[edge + 1]));
  }
  return largest;
}

/// Groups spare the search the pairs of edges of one contour, where contours are large. Small ones have few such pairs,
/// and to look at them too makes the second round short (clearance.h).
Grouping first_grouping(const Strands& strands) {
  bool ungrouped = true;
  for (std::size_t s = 0; s < strands.size(); ++s)
    ungrouped &= strands.group[s] == any_group || strands.simplicity[s] == Simplicity::assumed;
  return ungrouped || strands.points.size() <= tuning::small_strand * strands.size() ? Grouping::none
                                                                                     : Grouping::by_strand;
}

}  // namespace

Strands node(Strands strands, NodingReport& report, const Checkpoint& checkpoint) {
  strands.flags.assign(strands.points.size(), 0);
  flag_closed_strands(strands);
  LargeArray<Point> input;  // the vertices as given, once there were cuts
  Grouping grouping = first_grouping(strands);
  report.first.seeks_tangled = strands.has_assumed();
  FirstFindings* first = &report.first;
  for (bool moved = true; moved; grouping = Grouping::by_moved) {
    ++report.rounds;
    std::optional<Clearance> clearance;
    if (grouping == Grouping::none) clearance.emplace(strands);
    const LargeArray<EdgeCut> cuts = find_meetings(strands, grouping, Settling::of_round(report.rounds), checkpoint,
                                                   clearance ? &*clearance : nullptr, first);
    if (report.first.asks_for_change()) return strands;
    first = nullptr;
    report.cuts += cuts.size();
    if (cuts.empty()) break;
    if (input.empty() && report.measures_displacement) input = strands.points;
    insert_cuts(strands, cuts);
    moved = std::any_of(strands.flags.begin(), strands.flags.end(),
                        [](std::uint8_t flags) { return (flags & moved_flag) != 0; });
    // Where no piece can reach another, the last round has found nothing without looking.
    report.rounds += !moved;
  }
  if (!input.empty()) report.largest_displacement = displacement(strands, input);
  flag_strand_ends(strands);
  return strands;
}

}  // namespace oblast::internal::noding
