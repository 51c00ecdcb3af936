#include "overlay/collect.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <optional>

#include "memory/large_pages.h"
#include "noding/ring_tree.h"
#include "overlay/resolve.h"
#include "overlay/simple_ring.h"
#include "parallel/for_ranges.h"

namespace oblast {
namespace {

using noding::Group;
using noding::Simplicity;
using noding::Strands;
using noding::Winding;

/// Appends the ring to the points without repeated neighbours and without its closing point; -0.0 becomes 0.0. Where
/// fewer than three vertices are left, none are.
std::span<const Point> append_clean(std::span<const Point> ring, Array<Point>& points) {
  const std::size_t begin = points.size();
  for (const Point& p : ring) {
    const Point q{p.x + 0.0, p.y + 0.0};
    if (points.size() == begin || points.back() != q) points.push_back(q);
  }
  while (points.size() > begin + 1 && points.back() == points[begin]) points.pop_back();
  if (points.size() < begin + 3) points.resize(begin);
  return std::span(points).subspan(begin);
}

/// Reads polygons of an operand.
class PolygonReader {
 public:
  PolygonReader(const RegionView& operand, bool is_b, Group first_group, Control& control)
      : operand_(operand), is_b_(is_b), first_group_(first_group), control_(control) {}

  /// Appends polygons [begin, end) to the strands; the number of those whose rings were found to meet.
  std::uint64_t read(std::size_t begin, std::size_t end, Strands& strands) const {
    Scratch scratch;
    std::uint64_t resolved = 0;
    for (std::size_t p = begin; p < end; ++p)
      if (!read_as_it_is(p, scratch, strands)) resolved += resolve_polygon(p, strands);
    return resolved;
  }

 private:
  struct Scratch {
    Array<std::uint32_t> ends;  ///< of the polygon's rings, counted from its first point
    noding::RingTree tree;
  };

  /// False when the polygon's rings cannot be taken as they are.
  bool read_as_it_is(std::size_t polygon, Scratch& scratch, Strands& strands) const {
    const std::size_t begin = strands.points.size();
    scratch.ends.clear();
    for (std::uint32_t c = operand_.polygon_begin(polygon); c < operand_.polygon_end(polygon); ++c) {
      const std::span ring = append_clean(operand_.contour(c), strands.points);
      if (ring.empty()) continue;
      strands.points.push_back(Point(ring[0]));
      scratch.ends.push_back(static_cast<std::uint32_t>(strands.points.size() - begin));
    }
    const std::span rings = std::span(strands.points).subspan(begin);
    const bool taken = scratch.ends.size() > 1 ? add_rings(polygon, rings, scratch, strands)
                                               : scratch.ends.empty() || add_ring(polygon, rings, scratch, strands);
    if (!taken) strands.points.resize(begin);
    return taken;
  }

  /// Of a layer, whose polygons may share edges, each is looked at here, as node_strands would have to.
  bool add_ring(std::size_t polygon, std::span<const Point> closed, Scratch& scratch, Strands& strands) const {
    const std::span ring = closed.first(closed.size() - 1);
    const int convex = convex_turn(ring);
    const int turn = convex != 0 ? convex : turn_at_smallest(ring);
    if (turn == 0) return false;
    std::optional<bool> meet;
    if (convex != 0) {
      meet = false;
    } else if (operand_.polygon_count() > 1) {
      scratch.tree.build(closed, scratch.ends);
      meet = scratch.tree.edges_meet();
    }
    if (meet && *meet) return false;
    strands.close_strand(winding(turn), group(polygon), meet ? Simplicity::known : Simplicity::assumed);
    return true;
  }

  /// Where rings of one polygon do not meet, its region lies to the left of every second one around a place.
  bool add_rings(std::size_t polygon, std::span<const Point> points, Scratch& scratch, Strands& strands) const {
    scratch.tree.build(points, scratch.ends);
    const std::optional<bool> meet = scratch.tree.edges_meet();
    if (!meet || *meet) return false;
    const std::optional<Array<bool>> odd_depths = scratch.tree.odd_depths();
    if (!odd_depths) return false;
    const auto offset = static_cast<std::uint32_t>(strands.points.size() - points.size());
    for (std::size_t r = 0, begin = 0; r < scratch.ends.size(); begin = scratch.ends[r++]) {
      const int turn = turn_at_smallest(points.subspan(begin, scratch.ends[r] - 1 - begin));
      strands.close_strand(winding((*odd_depths)[r] ? -turn : turn), group(polygon));
      strands.ends.back() = offset + scratch.ends[r];
    }
    return true;
  }

  Winding winding(std::int32_t change) const { return is_b_ ? Winding{0, change} : Winding{change, 0}; }
  Group group(std::size_t polygon) const { return first_group_ + static_cast<Group>(polygon); }

  bool resolve_polygon(std::size_t polygon, Strands& strands) const {
    const std::uint32_t begin = operand_.polygon_begin(polygon), end = operand_.polygon_end(polygon);
    if (begin == end) return false;
    const std::uint32_t first_point = operand_.contour_begin(begin);
    Array<std::uint32_t> ends(operand_.contour_ends.begin() + begin, operand_.contour_ends.begin() + end);
    for (std::uint32_t& e : ends) e -= first_point;
    const RegionView rings{operand_.points.subspan(first_point, ends.back()), ends, {}};
    return resolve(rings, winding(1), group(polygon), control_, strands);
  }

  const RegionView& operand_;
  bool is_b_;
  Group first_group_;
  Control& control_;
};

void append(Strands& to, const Strands& from) {
  const auto offset = static_cast<std::uint32_t>(to.points.size());
  to.points.insert(to.points.end(), from.points.begin(), from.points.end());
  for (const std::uint32_t end : from.ends) to.ends.push_back(end + offset);
  to.change.insert(to.change.end(), from.change.begin(), from.change.end());
  to.group.insert(to.group.end(), from.group.begin(), from.group.end());
  to.simplicity.insert(to.simplicity.end(), from.simplicity.begin(), from.simplicity.end());
}

void collect_by_polygon(const RegionView& operand, bool is_b, Group first_group, Control& control, Strands& strands,
                        Statistics& statistics) {
  const PolygonReader reader(operand, is_b, first_group, control);
  const std::size_t count = operand.polygon_count(), polygons_a_part = grain(count, operand.points.size());
  const std::size_t parts = range_count(count, polygons_a_part);
  const auto read_part = [&](std::size_t part, Strands& to) {
    control.checkpoint(Stage::collect, static_cast<double>(part) / static_cast<double>(parts));
    return reader.read(part * polygons_a_part, std::min(count, (part + 1) * polygons_a_part), to);
  };
  if (parts == 1 || core_count() == 1) {
    for (std::size_t part = 0; part < parts; ++part) statistics.resolved_polygons += read_part(part, strands);
    return;
  }
  Array<Strands> read(parts);
  std::atomic<std::uint64_t> resolved = 0;
  tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) { resolved += read_part(part, read[part]); });
  for (Strands& part : read) {
    append(strands, part);
    part = {};
  }
  statistics.resolved_polygons += resolved;
}

void collect_as_directed(const RegionView& operand, bool is_b, Strands& strands) {
  for (std::size_t c = 0; c < operand.contour_count(); ++c) {
    const std::span ring = append_clean(operand.contour(c), strands.points);
    if (ring.empty()) continue;
    strands.points.push_back(Point(ring[0]));
    strands.close_strand(is_b ? Winding{0, 1} : Winding{1, 0}, noding::any_group);
  }
}

}  // namespace

Strands collect(const RegionView& a, const RegionView* b, const Options& options, Control& control,
                Statistics& statistics) {
  const StageClock clock(control, statistics, Stage::collect);
  Strands strands;
  strands.parity = {options.fill_a.kind == FillRule::Kind::even_odd, options.fill_b.kind == FillRule::Kind::even_odd};
  const std::size_t contours = a.contour_count() + (b ? b->contour_count() : 0);
  // Polygons that are resolved get a few vertices more.
  const std::size_t points = a.points.size() + (b ? b->points.size() : 0) + contours;
  reserve_in_large_pages(strands.points, points + points / 8);
  strands.ends.reserve(contours);
  strands.change.reserve(contours);
  strands.group.reserve(contours);
  strands.simplicity.reserve(contours);
  const auto add = [&](const RegionView& operand, bool is_b, const FillRule& rule, Group first_group) {
    if (rule.by_polygon())
      collect_by_polygon(operand, is_b, first_group, control, strands, statistics);
    else
      collect_as_directed(operand, is_b, strands);
  };
  add(a, false, options.fill_a, 1);
  if (b) add(*b, true, options.fill_b, 1 + static_cast<Group>(a.polygon_count()));
  return strands;
}

}  // namespace oblast
