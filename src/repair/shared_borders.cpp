#include "repair/shared_borders.h"

#include <oblast/features.h>

#include <algorithm>

#include "base/index.h"
#include "base/parallel.h"
#include "repair/size_bounds.h"

namespace oblast::internal::repairing {
namespace {

/// An edge of a piece asked for, as its neighbour runs along it.
struct Sought {
  Point from, to;
  std::uint32_t number;  ///< among all edges asked for
};

bool comes_before(const Sought& e, const Sought& f) {
  if (e.from != f.from) return lexicographically_less(e.from, f.from);
  return lexicographically_less(e.to, f.to);
}

/// Calls visit(p, q) for each edge of a polygon, in order.
template <class Visit>
void for_edges(const RegionView& pieces, std::uint32_t polygon, const Visit& visit) {
  for (std::uint32_t c = pieces.polygon_begin(polygon); c < pieces.polygon_end(polygon); ++c) {
    const std::span<const Point> ring = pieces.contour(c);
    for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
  }
}

}  // namespace

SharedBorders find_shared_borders(const RegionView& pieces, std::span<const std::uint32_t> asked) {
  Array<Sought> sought;
  Array<std::uint32_t> ends;
  for (const std::uint32_t piece : asked) {
    for_edges(pieces, piece, [&](const Point& p, const Point& q) {
      sought.push_back({q, p, static_cast<std::uint32_t>(sought.size())});
    });
    ends.push_back(checked_index(sought.size(), "edges of gaps and slivers"));
  }
  Array<SharedEdge> edges(sought.size(), SharedEdge{none, 0});
  parallel_sort(sought.begin(), sought.end(), comes_before);
  const std::size_t count = pieces.polygon_count();
  for_ranges(count, grain(count, pieces.points.size()), [&](std::size_t piece, std::size_t past) {
    for (; piece < past; ++piece) {
      const auto neighbour = static_cast<std::uint32_t>(piece);
      for_edges(pieces, neighbour, [&](const Point& p, const Point& q) {
        const Sought edge{p, q, 0};
        const auto at = std::lower_bound(sought.begin(), sought.end(), edge, comes_before);
        // No two pieces have an edge in one direction, so no other thread writes there.
        if (at != sought.end() && !comes_before(edge, *at)) edges[at->number] = {neighbour, edge_length(p, q)};
      });
    }
  });

  SharedBorders borders;
  for (std::uint32_t i = 0, k = 0; k < ends.size(); ++k) {
    for (; i < ends[k]; ++i)
      if (edges[i].neighbour != none) borders.edges.push_back(edges[i]);
    borders.ends.push_back(static_cast<std::uint32_t>(borders.edges.size()));
  }
  return borders;
}

std::uint32_t longest_owner(Array<OwnedLength> lengths) {
  std::stable_sort(lengths.begin(), lengths.end(),
                   [](const OwnedLength& p, const OwnedLength& q) { return p.owner < q.owner; });
  OwnedLength longest{no_feature, 0};
  for (std::size_t i = 0; i < lengths.size();) {
    OwnedLength sum{lengths[i].owner, 0};
    for (; i < lengths.size() && lengths[i].owner == sum.owner; ++i) sum.length += lengths[i].length;
    if (longest.owner == no_feature || sum.length > longest.length) longest = sum;
  }
  return longest.owner;
}

}  // namespace oblast::internal::repairing
