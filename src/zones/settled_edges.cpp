#include "zones/settled_edges.h"

#include <algorithm>

#include "base/parallel.h"
#include "collect/collect.h"
#include "noding/node_strands.h"
#include "overlay/pipeline.h"

namespace oblast::internal::zoning {
namespace {

using noding::Strands;
using noding::Winding;

Point clean(const Point& p) { return {p.x + 0.0, p.y + 0.0}; }

std::int32_t once(std::uint32_t source) { return static_cast<std::int32_t>(source) + 1; }

/// The line as paths that ascend lexicographically, and along which y rises, or falls. Noding may make pieces of an
/// edge vertical, and these turn around where y falls. So paths that fall have a source of their own: then no two
/// pieces of one source run in opposite directions, and none cancel. Appends the line to `points` if it has no length.
void add_line(std::span<const Point> line, std::uint32_t object, std::uint32_t objects, Strands& strands,
              Array<LonePoint>& points) {
  Array<Point> path;
  for (const Point& p : line)
    if (path.empty() || path.back() != clean(p)) path.push_back(clean(p));
  if (path.size() == 1) points.push_back({path[0], object});
  const auto ascends = [&](std::size_t i) { return lexicographically_less(path[i], path[i + 1]); };
  const auto rises = [&](std::size_t i) {
    return ascends(i) ? path[i].y <= path[i + 1].y : path[i].y >= path[i + 1].y;
  };
  for (std::size_t begin = 0, end; begin + 1 < path.size(); begin = end) {
    end = begin + 1;
    while (end + 1 < path.size() && ascends(end) == ascends(begin) && rises(end) == rises(begin)) ++end;
    const auto first = path.begin() + static_cast<std::ptrdiff_t>(begin),
               past = path.begin() + static_cast<std::ptrdiff_t>(end + 1);
    if (ascends(begin))
      strands.points.insert(strands.points.end(), first, past);
    else
      strands.points.insert(strands.points.end(), std::reverse_iterator(past), std::reverse_iterator(first));
    strands.close_strand({0, once(rises(begin) ? object : objects + object)}, noding::any_group);
  }
}

/// An edge of a strand.
struct Piece {
  Point low, high;
  Winding change;  ///< of the edge from low to high
};

LargeArray<Piece> pieces_of(const Strands& strands) {
  LargeArray<Piece> pieces;
  pieces.reserve(strands.points.size());
  Steps steps(strands.points.size());
  for (std::uint32_t s = 0; s < strands.size(); ++s) {
    if (strands.change[s].is_zero()) continue;
    for (std::uint32_t v = strands.begin(s); v + 1 < strands.ends[s]; ++v) {
      steps();
      const Point &p = strands.points[v], &q = strands.points[v + 1];
      if (lexicographically_less(p, q))
        pieces.push_back({p, q, strands.change[s]});
      else
        pieces.push_back({q, p, -strands.change[s]});
    }
  }
  parallel_sort(pieces.begin(), pieces.end(), [](const Piece& p, const Piece& q) {
    return p.low != q.low ? lexicographically_less(p.low, q.low) : lexicographically_less(p.high, q.high);
  });
  return pieces;
}

/// One edge in place of all its copies.
LargeArray<SettledEdge> edges_of(const LargeArray<Piece>& pieces, std::uint32_t objects,
                                 noding::SourceChanges& changes) {
  LargeArray<SettledEdge> edges;
  edges.reserve(pieces.size());
  Steps steps(pieces.size());
  for (std::size_t i = 0, end; i < pieces.size(); i = end) {
    Winding change = pieces[i].change;
    for (end = i + 1; end < pieces.size() && pieces[end].low == pieces[i].low && pieces[end].high == pieces[i].high;
         ++end)
      change = {changes.add(change.a, pieces[end].change.a), changes.add(change.b, pieces[end].change.b)};
    steps();
    SettledEdge edge{pieces[i].low, pieces[i].high, 0, none, none};
    changes.for_each(change.a, [&](std::uint32_t object, std::int32_t count) {
      edge.cover += count;
      edge.outline_of = std::min(edge.outline_of, object);
    });
    changes.for_each(change.b, [&](std::uint32_t source, std::int32_t) {
      edge.line_of = std::min(edge.line_of, source < objects ? source : source - objects);
    });
    if (edge.outline_of != none || edge.line_of != none) edges.push_back(edge);
  }
  return edges;
}

/// The strands of polygons alone.
Strands polygons_of(Strands strands) {
  Strands polygons;
  polygons.rules = strands.rules;
  for (std::uint32_t s = 0; s < strands.size(); ++s) {
    if (strands.change[s].a == 0) continue;
    polygons.points.insert(polygons.points.end(), strands.points.begin() + strands.begin(s),
                           strands.points.begin() + strands.ends[s]);
    polygons.close_strand({strands.change[s].a, 0}, noding::any_group);
  }
  return polygons;
}

void sort_points(Array<LonePoint>& points) {
  parallel_sort(points.begin(), points.end(), [](const LonePoint& p, const LonePoint& q) {
    return p.at != q.at ? lexicographically_less(p.at, q.at) : p.object < q.object;
  });
  const auto same = [](const LonePoint& p, const LonePoint& q) { return p.at == q.at; };
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
}

}  // namespace

SettledObjects settle_objects(const Objects& objects, noding::SourceChanges& changes, Control& control,
                              Statistics& statistics) {
  SettledObjects settled;
  const Operand polygons{objects.shapes.regions, false, FillRule::polygons(), objects.of_polygon};
  Strands strands = collect({&polygons, 1}, resolve_by_pipeline(control), statistics.resolved_polygons);
  strands.rules.sources = &changes;
  for (std::size_t l = 0; l < objects.shapes.lines.size(); ++l)
    add_line(objects.shapes.lines[l], objects.of_line[l], objects.count, strands, settled.points);
  for (std::size_t i = 0; i < objects.shapes.points.size(); ++i)
    settled.points.push_back({clean(objects.shapes.points[i]), objects.of_point[i]});
  sort_points(settled.points);
  if (strands.size() == 0) return settled;
  noding::NodingReport report(false);
  strands = node_strands(std::move(strands), report, resolve_by_pipeline(control), statistics.resolved_polygons);
  settled.edges = edges_of(pieces_of(strands), objects.count, changes);
  settled.polygons = polygons_of(std::move(strands));
  return settled;
}

}  // namespace oblast::internal::zoning
