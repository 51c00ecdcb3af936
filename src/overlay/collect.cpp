#include "overlay/collect.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "overlay/resolve.h"
#include "overlay/simple_ring.h"

namespace oblast {
namespace {

using noding::Group;
using noding::Simplicity;
using noding::Strands;
using noding::Winding;

/// Appends the ring to the points without repeated neighbours and without its closing point; -0.0 becomes 0.0. Where
/// fewer than three vertices are left, none are.
std::span<const Point> append_clean(std::span<const Point> ring, std::vector<Point>& points) {
  const std::size_t begin = points.size();
  for (const Point& p : ring) {
    const Point q{p.x + 0.0, p.y + 0.0};
    if (points.size() == begin || points.back() != q) points.push_back(q);
  }
  while (points.size() > begin + 1 && points.back() == points[begin]) points.pop_back();
  if (points.size() < begin + 3) points.resize(begin);
  return std::span(points).subspan(begin);
}

/// Closes the strand whose points begin there.
void close(Winding winding, Group group, Simplicity simplicity, std::size_t begin, Strands& strands) {
  strands.points.push_back(Point(strands.points[begin]));
  strands.close_strand(winding, group, simplicity);
}

/// Reads polygons of an operand.
class PolygonReader {
 public:
  PolygonReader(const RegionView& operand, bool is_b, Group first_group, Control& control)
      : operand_(operand), is_b_(is_b), first_group_(first_group), control_(control) {}

  /// Appends polygons [begin, end) to the strands; the number of those whose rings were found to meet.
  std::uint64_t read(std::size_t begin, std::size_t end, Strands& strands) const {
    std::uint64_t resolved = 0;
    for (std::size_t p = begin; p < end; ++p)
      if (!read_one_ring(p, strands)) resolved += resolve_polygon(p, strands);
    return resolved;
  }

 private:
  /// False when the polygon is not a ring that can be taken as it is.
  bool read_one_ring(std::size_t polygon, Strands& strands) const {
    if (operand_.polygon_end(polygon) - operand_.polygon_begin(polygon) != 1) return false;
    const std::size_t begin = strands.points.size();
    const std::span ring = append_clean(operand_.contour(operand_.polygon_begin(polygon)), strands.points);
    if (ring.empty()) return true;
    const int convex = convex_turn(ring);
    const int turn = convex != 0 ? convex : turn_at_smallest(ring);
    if (turn == 0) {
      strands.points.resize(begin);
      return false;
    }
    close(winding(turn), group(polygon), convex != 0 ? Simplicity::known : Simplicity::assumed, begin, strands);
    return true;
  }

  Winding winding(std::int32_t change) const { return is_b_ ? Winding{0, change} : Winding{change, 0}; }
  Group group(std::size_t polygon) const { return first_group_ + static_cast<Group>(polygon); }

  bool resolve_polygon(std::size_t polygon, Strands& strands) const {
    const std::uint32_t begin = operand_.polygon_begin(polygon), end = operand_.polygon_end(polygon);
    if (begin == end) return false;
    const std::uint32_t first_point = operand_.contour_begin(begin);
    std::vector<std::uint32_t> ends(operand_.contour_ends.begin() + begin, operand_.contour_ends.begin() + end);
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
  constexpr std::size_t polygons_a_part = 2048;
  const PolygonReader reader(operand, is_b, first_group, control);
  const std::size_t count = operand.polygon_count();
  if (count <= polygons_a_part) {
    control.checkpoint(Stage::collect, 0);
    statistics.resolved_polygons += reader.read(0, count, strands);
    return;
  }
  const std::size_t parts = (count + polygons_a_part - 1) / polygons_a_part;
  std::vector<Strands> read(parts);
  std::atomic<std::uint64_t> resolved = 0;
  tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
    control.checkpoint(Stage::collect, static_cast<double>(part) / static_cast<double>(parts));
    const std::size_t end = std::min(count, (part + 1) * polygons_a_part);
    resolved += reader.read(part * polygons_a_part, end, read[part]);
  });
  for (Strands& part : read) {
    append(strands, part);
    part = {};
  }
  statistics.resolved_polygons += resolved;
}

void collect_as_directed(const RegionView& operand, bool is_b, Strands& strands) {
  for (std::size_t c = 0; c < operand.contour_count(); ++c) {
    const std::size_t begin = strands.points.size();
    if (!append_clean(operand.contour(c), strands.points).empty())
      close(is_b ? Winding{0, 1} : Winding{1, 0}, noding::any_group, Simplicity::known, begin, strands);
  }
}

}  // namespace

Strands collect(const RegionView& a, const RegionView* b, const Options& options, Control& control,
                Statistics& statistics) {
  const StageClock clock(statistics, Stage::collect);
  Strands strands;
  strands.parity = {options.fill_a.kind == FillRule::Kind::even_odd, options.fill_b.kind == FillRule::Kind::even_odd};
  const std::size_t contours = a.contour_count() + (b ? b->contour_count() : 0);
  strands.points.reserve(a.points.size() + (b ? b->points.size() : 0) + contours);
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
