#include "check/vertex_passes.h"

#include <algorithm>
#include <optional>

#include "base/call_memory.h"
#include "base/parallel.h"
#include "check/edge_pair.h"
#include "exact/orientation.h"

namespace oblast::internal::checking {
namespace {

/// A ring goes from u through the point to v.
struct Pass {
  std::uint32_t index, ring;
  Point u, v;
};

/// Whether w lies in the sector that begins at u and goes counter-clockwise to v. REQUIRES: u, v and w lie in three
/// directions from `at`.
bool in_sector(const Point& at, const Point& u, const Point& v, const Point& w) {
  const int uv = exact::orientation(at, u, v), uw = exact::orientation(at, u, w), wv = exact::orientation(at, w, v);
  if (uv > 0) return uw > 0 && wv > 0;
  if (uv < 0) return uw > 0 || wv > 0;
  return uw > 0;  // u and v are opposite
}

/// Nothing if edges of the passes go the same way.
std::optional<VertexMeeting> meeting_of(const Point& at, const Pass& p, const Pass& q) {
  if (same_way(at, p.u, p.v) || same_way(at, q.u, q.v)) return {};  // spikes
  for (const Point* const s : {&p.u, &p.v})
    for (const Point* const t : {&q.u, &q.v})
      if (same_way(at, *s, *t)) return {};
  return in_sector(at, p.u, p.v, q.u) == in_sector(at, p.u, p.v, q.v) ? VertexMeeting::touch : VertexMeeting::cross;
}

}  // namespace

void for_common_vertices(const FeatureRings& rings,
                         const std::function<void(VertexMeeting, std::uint32_t, std::uint32_t)>& found) {
  Array<std::uint32_t> order;
  order.reserve(rings.points.size());
  for (std::uint32_t r = 0; r < rings.size(); ++r)
    for (std::uint32_t i = rings.begin(r); i + 1 < rings.ends[r]; ++i) order.push_back(i);
  const Array<Point>& points = rings.points;
  parallel_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return points[i] == points[j] ? i < j : lexicographically_less(points[i], points[j]);
  });
  Array<Pass> passes;
  for (std::size_t from = 0; from < order.size();) {
    std::size_t past = from + 1;
    while (past < order.size() && points[order[past]] == points[order[from]]) ++past;
    passes.clear();
    for (std::size_t k = from; past - from > 1 && k < past; ++k) {
      const std::uint32_t i = order[k], ring = rings.ring_of(i);
      const Pass pass{i, ring, points[rings.before(i, ring)], points[i + 1]};
      const Pass* touched = nullptr;
      bool crosses = false;
      std::uint32_t seen = FeaturePlace::none;  // the last ring of which a pass was reported
      for (const Pass& other : passes) {
        const auto meeting = meeting_of(points[i], pass, other);
        if (!meeting) continue;
        if (*meeting == VertexMeeting::cross) {
          found(VertexMeeting::cross, i, other.index);
          crosses = true;
          break;
        }
        if (other.ring == ring && !touched) touched = &other;
      }
      for (const Pass& other : passes) {
        if (crosses || touched) break;
        if (other.ring == seen || !meeting_of(points[i], pass, other)) continue;
        seen = other.ring;
        found(VertexMeeting::touch, i, other.index);
      }
      if (!crosses && touched) found(VertexMeeting::touch, i, touched->index);
      passes.push_back(pass);
    }
    from = past;
  }
}

}  // namespace oblast::internal::checking
