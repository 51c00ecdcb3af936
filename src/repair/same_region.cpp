#include "repair/same_region.h"

#include <algorithm>

#include "base/call_memory.h"

namespace oblast::internal::repairing {
namespace {

/// An outer ring counter-clockwise, then holes clockwise.
using Polygon = Array<Ring>;

/// No polygons if some ring cannot be one of a valid polygon.
Array<Polygon> polygons_in_order(const RegionView& regions) {
  Array<Polygon> polygons;
  for (std::size_t p = 0; p < regions.polygon_count(); ++p) {
    const std::uint32_t begin = regions.polygon_begin(p), end = regions.polygon_end(p);
    if (begin == end) continue;
    Polygon& polygon = polygons.emplace_back();
    for (std::uint32_t c = begin; c < end; ++c) {
      polygon.push_back(ring_in_order(regions.contour(c), c != begin));
      if (polygon.back().empty()) return {};
    }
    std::sort(polygon.begin() + 1, polygon.end(), comes_before);
  }
  std::sort(polygons.begin(), polygons.end(),
            [](const Polygon& p, const Polygon& q) { return comes_before(p[0], q[0]); });
  return polygons;
}

}  // namespace

bool is_same_region(const RegionView& feature, const RegionView& resolved, MoreVertices more) {
  const Array<Polygon> ours = polygons_in_order(feature);
  if (ours.size() != resolved.polygon_count()) return false;
  const Array<Polygon> theirs = polygons_in_order(resolved);
  if (ours.empty()) return feature.points.empty();
  return std::equal(ours.begin(), ours.end(), theirs.begin(), theirs.end(), [&](const Polygon& p, const Polygon& q) {
    return std::equal(p.begin(), p.end(), q.begin(), q.end(),
                      [&](const Ring& r, const Ring& s) { return is_same_ring(r, s, more); });
  });
}

}  // namespace oblast::internal::repairing
