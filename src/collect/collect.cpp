#include "collect/collect.h"

#include <algorithm>
#include <atomic>
#include <optional>

#include "base/index.h"
#include "base/large_pages.h"
#include "base/parallel.h"
#include "noding/simple_ring.h"
#include "plane/ring_tree.h"

namespace oblast::internal {
namespace {

using noding::Group;
using noding::Simplicity;
using noding::Strands;
using noding::Winding;

/// Appends the ring to the points, without repeated neighbours and without its closing point. -0.0 becomes 0.0. If
/// fewer than three vertices remain, appends nothing.
std::span<const Point> append_clean(std::span<const Point> ring, LargeArray<Point>& points) {
  const std::size_t begin = points.size();
  points.resize(begin + ring.size());
  Point* const first = points.data() + begin;
  Point* past = first;
  for (const Point& p : ring) {
    const Point q{p.x + 0.0, p.y + 0.0};
    *past = q;
    past += past == first || past[-1] != q;
  }
  while (past > first + 1 && past[-1] == *first) --past;
  if (past < first + 3) past = first;
  points.resize(static_cast<std::size_t>(past - points.data()));
  return std::span(points).subspan(begin);
}

/// Reserves memory for so many contours and vertices. Polygons that are resolved need a few more.
void reserve(Strands& strands, std::size_t vertices, std::size_t count) {
  const std::size_t points = vertices + count;
  reserve_in_large_pages(strands.points, points + points / 8);
  strands.ends.reserve(count);
  strands.change.reserve(count);
  strands.group.reserve(count);
  strands.simplicity.reserve(count);
}

/// Reads polygons of an operand.
class PolygonReader {
 public:
  PolygonReader(const Operand& operand, Group first_group, const Resolve& resolve)
      : operand_(operand.regions),
        is_b_(operand.is_b),
        sources_(operand.sources),
        first_group_(first_group),
        resolve_(resolve) {}

  /// Reserves memory for polygons [begin, end). REQUIRES: begin < end.
  void make_room(std::size_t begin, std::size_t end, Strands& strands) const {
    const std::uint32_t first = operand_.polygon_begin(begin), past = operand_.polygon_end(end - 1);
    reserve(strands, operand_.contour_begin(past) - operand_.contour_begin(first), past - first);
  }

  /// Appends polygons [begin, end) to the strands. Returns the number of polygons whose rings meet.
  std::uint64_t read(std::size_t begin, std::size_t end, Strands& strands) const {
    Scratch scratch;
    std::uint64_t resolved = 0;
    for (std::size_t p = begin; p < end; ++p)
      if (!read_as_it_is(p, scratch, strands)) resolved += resolve_polygon(p, strands);
    return resolved;
  }

 private:
  struct Scratch {
    Array<std::uint32_t> ends;  ///< of the rings of the polygon, counted from its first point
    RingTree tree;
  };

  /// False if the rings of the polygon cannot be used as they are.
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

  /// In a layer, polygons may share edges. So each is tested here; otherwise node_strands would have to test it.
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
    strands.close_strand(change(polygon, turn), group(polygon), meet ? Simplicity::known : Simplicity::assumed);
    return true;
  }

  /// If the rings of a polygon do not meet, its region lies left of every second ring around a point.
  bool add_rings(std::size_t polygon, std::span<const Point> points, Scratch& scratch, Strands& strands) const {
    scratch.tree.build(points, scratch.ends);
    const std::optional<bool> meet = scratch.tree.edges_meet();
    if (!meet || *meet) return false;
    const std::optional<Array<bool>> odd_depths = scratch.tree.odd_depths();
    if (!odd_depths) return false;
    const auto offset = static_cast<std::uint32_t>(strands.points.size() - points.size());
    for (std::size_t r = 0, begin = 0; r < scratch.ends.size(); begin = scratch.ends[r++]) {
      const int turn = turn_at_smallest(points.subspan(begin, scratch.ends[r] - 1 - begin));
      strands.close_strand(change(polygon, (*odd_depths)[r] ? -turn : turn), group(polygon));
      strands.ends.back() = offset + scratch.ends[r];
    }
    return true;
  }

  Winding change(std::size_t polygon, std::int32_t turn) const {
    const std::int32_t change = sources_.empty() ? turn : turn * static_cast<std::int32_t>(sources_[polygon] + 1);
    return is_b_ ? Winding{0, change} : Winding{change, 0};
  }
  Group group(std::size_t polygon) const { return first_group_ + static_cast<Group>(polygon); }

  bool resolve_polygon(std::size_t polygon, Strands& strands) const {
    const std::uint32_t begin = operand_.polygon_begin(polygon), end = operand_.polygon_end(polygon);
    if (begin == end) return false;
    return append_resolved(resolve_(operand_.contours_between(begin, end)), change(polygon, 1), group(polygon),
                           strands);
  }

  const RegionView& operand_;
  bool is_b_;
  std::span<const std::uint32_t> sources_;
  Group first_group_;
  const Resolve& resolve_;
};

/// Copies all strands of `from` into the room for them, which begins at `first_point` and `first_strand`.
void put(const Strands& from, Strands& to, std::size_t first_point, std::size_t first_strand) {
  const auto strand = static_cast<std::ptrdiff_t>(first_strand);
  std::copy(from.points.begin(), from.points.end(), to.points.begin() + static_cast<std::ptrdiff_t>(first_point));
  std::transform(from.ends.begin(), from.ends.end(), to.ends.begin() + strand,
                 [&](std::uint32_t end) { return end + static_cast<std::uint32_t>(first_point); });
  std::copy(from.change.begin(), from.change.end(), to.change.begin() + strand);
  std::copy(from.group.begin(), from.group.end(), to.group.begin() + strand);
  std::copy(from.simplicity.begin(), from.simplicity.end(), to.simplicity.begin() + strand);
}

/// Appends the strands of all parts, one part after another, and empties the parts.
void append(Strands& to, Array<Strands>& parts) {
  Array<std::size_t> first_point, first_strand;
  std::size_t points = to.points.size(), count = to.size();
  for (const Strands& part : parts) {
    first_point.push_back(points);
    first_strand.push_back(count);
    points += part.points.size();
    count += part.size();
  }
  check_count(points, "vertices of strands");
  to.resize(points, count);
  for_ranges(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      put(parts[i], to, first_point[i], first_strand[i]);
      parts[i] = {};
    }
  });
}

void collect_by_polygon(const Operand& operand, Group first_group, const Resolve& resolve, Strands& strands,
                        std::uint64_t& resolved_polygons) {
  const PolygonReader reader(operand, first_group, resolve);
  // The test whether a ring meets itself takes about ten times as long as copying its vertices.
  const std::size_t count = operand.regions.polygon_count(),
                    polygons_a_part = grain(count, 8 * operand.regions.points.size());
  const std::size_t parts = range_count(count, polygons_a_part);
  const auto begin_of = [&](std::size_t part) { return std::min(count, part * polygons_a_part); };
  const auto read_part = [&](std::size_t part, Strands& to) {
    return reader.read(begin_of(part), begin_of(part + 1), to);
  };
  if (parts == 1 || core_count() == 1) {
    for_ranges(parts, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t part = begin; part < end; ++part) resolved_polygons += read_part(part, strands);
    });
    return;
  }
  Array<Strands> read(parts);
  std::atomic<std::uint64_t> resolved = 0;
  for_ranges(parts, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t part = begin; part < end; ++part) {
      reader.make_room(begin_of(part), begin_of(part + 1), read[part]);
      resolved += read_part(part, read[part]);
    }
  });
  append(strands, read);
  resolved_polygons += resolved;
}

void collect_as_directed(const RegionView& operand, bool is_b, Strands& strands) {
  Steps steps(operand.contour_count());
  for (std::size_t c = 0; c < operand.contour_count(); ++c) {
    steps();
    const std::span ring = append_clean(operand.contour(c), strands.points);
    if (ring.empty()) continue;
    strands.points.push_back(Point(ring[0]));
    strands.close_strand(is_b ? Winding{0, 1} : Winding{1, 0}, noding::any_group);
  }
}

}  // namespace

Strands collect(std::span<const Operand> operands, const Resolve& resolve, std::uint64_t& resolved_polygons) {
  Strands strands;
  std::size_t vertices = 0, contours = 0;
  for (const Operand& operand : operands) {
    vertices += operand.regions.points.size();
    contours += operand.regions.contour_count();
    (operand.is_b ? strands.rules.parity_b : strands.rules.parity_a) = operand.rule.kind == FillRule::Kind::even_odd;
  }
  reserve(strands, vertices, contours);
  Group first_group = 1;
  for (const Operand& operand : operands) {
    if (operand.rule.by_polygon())
      collect_by_polygon(operand, first_group, resolve, strands, resolved_polygons);
    else
      collect_as_directed(operand.regions, operand.is_b, strands);
    first_group += static_cast<Group>(operand.regions.polygon_count());
  }
  return strands;
}

}  // namespace oblast::internal
