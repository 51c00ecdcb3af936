#include "overlay/collect.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>

#include "overlay/resolve.h"
#include "overlay/simple_ring.h"

namespace oblast {
namespace {

using noding::Group;
using noding::Simplicity;
using noding::Strands;
using noding::Winding;

/// The ring without repeated neighbours and without its closing point; -0.0 becomes 0.0.
void clean_ring(std::span<const Point> ring, std::vector<Point>& cleaned) {
  cleaned.clear();
  for (const Point& p : ring) {
    const Point q{p.x + 0.0, p.y + 0.0};
    if (cleaned.empty() || cleaned.back() != q) cleaned.push_back(q);
  }
  while (cleaned.size() > 1 && cleaned.back() == cleaned.front()) cleaned.pop_back();
}

void append_closed(std::span<const Point> ring, Winding winding, Group group, Simplicity simplicity, Strands& strands) {
  strands.points.insert(strands.points.end(), ring.begin(), ring.end());
  strands.points.push_back(ring[0]);
  strands.close_strand(winding, group, simplicity);
}

/// Reads some of an operand's polygons into strands of their own.
class PolygonReader {
 public:
  PolygonReader(const RegionView& operand, bool is_b, Group first_group, Control& control)
      : operand_(operand), is_b_(is_b), first_group_(first_group), control_(control) {}

  void read(std::size_t polygon) {
    if (operand_.polygon_end(polygon) - operand_.polygon_begin(polygon) == 1) {
      clean_ring(operand_.contour(operand_.polygon_begin(polygon)), ring_);
      if (ring_.size() < 3) return;
      const int convex = convex_turn(ring_);
      const int turn = convex != 0 ? convex : turn_at_smallest(ring_);
      if (turn != 0) {
        const Simplicity simplicity = convex != 0 ? Simplicity::known : Simplicity::assumed;
        append_closed(ring_, winding(turn), group(polygon), simplicity, strands_);
        return;
      }
    }
    resolve_polygon(polygon);
  }

  Strands strands_;
  std::uint64_t resolved_ = 0;

 private:
  Winding winding(std::int32_t change) const { return is_b_ ? Winding{0, change} : Winding{change, 0}; }
  Group group(std::size_t polygon) const { return first_group_ + static_cast<Group>(polygon); }

  void resolve_polygon(std::size_t polygon) {
    const std::uint32_t begin = operand_.polygon_begin(polygon), end = operand_.polygon_end(polygon);
    if (begin == end) return;
    const std::uint32_t first_point = operand_.contour_begin(begin);
    std::vector<std::uint32_t> ends(operand_.contour_ends.begin() + begin, operand_.contour_ends.begin() + end);
    for (std::uint32_t& e : ends) e -= first_point;
    const RegionView rings{operand_.points.subspan(first_point, ends.back()), ends, {}};
    resolved_ += resolve(rings, winding(1), group(polygon), control_, strands_);
  }

  const RegionView& operand_;
  bool is_b_;
  Group first_group_;
  Control& control_;
  std::vector<Point> ring_;
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
  const std::size_t count = operand.polygon_count();
  const std::size_t parts = (count + polygons_a_part - 1) / polygons_a_part;
  std::vector<PolygonReader> readers(parts, PolygonReader(operand, is_b, first_group, control));
  tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
    control.checkpoint(Stage::collect, static_cast<double>(part) / static_cast<double>(parts));
    const std::size_t end = std::min(count, (part + 1) * polygons_a_part);
    for (std::size_t p = part * polygons_a_part; p < end; ++p) readers[part].read(p);
  });
  for (PolygonReader& reader : readers) {
    append(strands, reader.strands_);
    statistics.resolved_polygons += reader.resolved_;
    reader.strands_ = {};
  }
}

void collect_as_directed(const RegionView& operand, bool is_b, Strands& strands) {
  std::vector<Point> ring;
  for (std::size_t c = 0; c < operand.contour_count(); ++c) {
    clean_ring(operand.contour(c), ring);
    if (ring.size() >= 3)
      append_closed(ring, is_b ? Winding{0, 1} : Winding{1, 0}, noding::any_group, Simplicity::known, strands);
  }
}

}  // namespace

Strands collect(const RegionView& a, const RegionView* b, const Options& options, Control& control,
                Statistics& statistics) {
  const StageClock clock(statistics, Stage::collect);
  Strands strands;
  strands.parity = {options.fill_a.kind == FillRule::Kind::even_odd, options.fill_b.kind == FillRule::Kind::even_odd};
  strands.points.reserve(a.points.size() + a.contour_count() + (b ? b->points.size() + b->contour_count() : 0));
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
