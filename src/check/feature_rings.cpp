#include "check/feature_rings.h"

#include <algorithm>
#include <numeric>

#include "exact/orientation.h"
#include "plane/smallest_vertex.h"

namespace oblast::internal::checking {
namespace {

using enum FeatureFaultKind;

/// Appends a ring without vertices that repeat the one before. Returns whether three are left.
bool append_ring(std::span<const Point> contour, FeatureRings& rings, std::vector<FeatureFault>& faults,
                 std::uint32_t c) {
  const std::size_t begin = rings.points.size();
  for (std::uint32_t v = 0; v < contour.size(); ++v) {
    const Point p{contour[v].x + 0.0, contour[v].y + 0.0};  // without -0.0
    const bool last = v + 1 == contour.size();
    const bool repeated = last ? contour.size() > 1 && contour[0] == contour[v] : contour[v + 1] == contour[v];
    if (repeated) faults.push_back({repeated_vertex, {rings.feature, c, v}, {}, p});
    if (repeated) continue;  // the last of equal vertices stands for them
    rings.points.push_back(p);
    rings.vertex.push_back(v);
  }
  if (rings.points.size() - begin >= 3) return true;
  rings.points.resize(begin);
  rings.vertex.resize(begin);
  const Point p = contour.empty() ? Point{} : contour[0];
  faults.push_back({too_few_points, {rings.feature, c, 0}, {}, p});
  return false;
}

void find_spikes(FeatureRings& rings, std::uint32_t ring, std::vector<FeatureFault>& faults) {
  for (std::uint32_t i = rings.begin(ring); i + 1 < rings.ends[ring]; ++i) {
    const Point &a = rings.points[rings.before(i, ring)], &b = rings.points[i], &c = rings.points[i + 1];
    if (lexicographically_less(a, b) == lexicographically_less(b, c) || exact::orientation(a, b, c) != 0) continue;
    rings.broken[ring] = 1;
    faults.push_back({spike, rings.place(ring, i), {}, b});
  }
}

/// From the smallest vertex on, in the direction in which the smaller neighbour follows.
Array<Point> canonical(const FeatureRings& rings, std::uint32_t ring) {
  const std::uint32_t begin = rings.begin(ring), count = rings.ends[ring] - begin - 1;
  const std::span<const Point> points(rings.points.data() + begin, count);
  const std::uint32_t smallest = smallest_vertex(points).vertex;
  const bool backward = lexicographically_less(points[(smallest + count - 1) % count], points[(smallest + 1) % count]);
  Array<Point> result(count);
  for (std::uint32_t i = 0; i < count; ++i) result[i] = points[(smallest + (backward ? count - i : i)) % count];
  return result;
}

/// Shells of one feature, or rings of one part.
bool may_repeat(const FeatureRings& rings, std::uint32_t a, std::uint32_t b) {
  return rings.polygon[a] == rings.polygon[b] || (!rings.is_hole[a] && !rings.is_hole[b]);
}

/// Finds rings that repeat one before, and takes them out.
void remove_repeated(FeatureRings& rings, std::vector<FeatureFault>& faults) {
  const auto count = static_cast<std::uint32_t>(rings.size());
  // Only rings with the same number of vertices, and the same smallest vertex, can be the same.
  Array<Point> smallest(count);
  Array<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  for (std::uint32_t r = 0; r < count; ++r) {
    const std::uint32_t begin = rings.begin(r);
    const std::span<const Point> points(rings.points.data() + begin, rings.ends[r] - begin - 1);
    smallest[r] = points[smallest_vertex(points).vertex];
  }
  const auto length = [&](std::uint32_t r) { return rings.ends[r] - rings.begin(r); };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (length(a) != length(b)) return length(a) < length(b);
    if (smallest[a] != smallest[b]) return lexicographically_less(smallest[a], smallest[b]);
    return a < b;
  });
  Array<std::uint8_t> repeated(count, 0);
  bool any = false;
  for (std::uint32_t from = 0; from < count;) {
    std::uint32_t past = from + 1;
    while (past < count && length(order[past]) == length(order[from]) && smallest[order[past]] == smallest[order[from]])
      ++past;
    Array<std::pair<std::uint32_t, Array<Point>>> kept;  // rings of this group that differ
    for (std::uint32_t i = from; past - from > 1 && i < past; ++i) {
      Array<Point> form = canonical(rings, order[i]);
      const auto same = std::find_if(kept.begin(), kept.end(), [&](const auto& k) {
        return may_repeat(rings, k.first, order[i]) && k.second == form;
      });
      if (same == kept.end()) {
        kept.emplace_back(order[i], std::move(form));
        continue;
      }
      any = true;
      repeated[order[i]] = 1;
      faults.push_back({repeated_ring, rings.place(order[i], rings.begin(order[i])),
                        rings.place(same->first, rings.begin(same->first)), rings.points[rings.begin(order[i])]});
    }
    from = past;
  }
  if (!any) return;
  Array<std::uint32_t> left;
  for (std::uint32_t r = 0; r < count; ++r)
    if (!repeated[r]) left.push_back(r);
  keep_rings(rings, left);
}

}  // namespace

std::uint32_t FeatureRings::ring_of(std::uint32_t index) const {
  return static_cast<std::uint32_t>(std::upper_bound(ends.begin(), ends.end(), index) - ends.begin());
}

void keep_rings(FeatureRings& rings, std::span<const std::uint32_t> order) {
  FeatureRings kept;
  kept.feature = rings.feature;
  for (const std::uint32_t r : order) {
    const auto begin = rings.begin(r), end = rings.ends[r];
    kept.points.insert(kept.points.end(), rings.points.begin() + begin, rings.points.begin() + end);
    kept.vertex.insert(kept.vertex.end(), rings.vertex.begin() + begin, rings.vertex.begin() + end);
    kept.ends.push_back(static_cast<std::uint32_t>(kept.points.size()));
    kept.contour.push_back(rings.contour[r]);
    kept.polygon.push_back(rings.polygon[r]);
    kept.is_hole.push_back(rings.is_hole[r]);
    kept.broken.push_back(rings.broken[r]);
  }
  rings = std::move(kept);
}

void collect_rings(const FeatureSpan& feature, FeatureRings& rings, std::vector<FeatureFault>& faults) {
  rings.points.clear(), rings.vertex.clear(), rings.ends.clear();
  rings.contour.clear(), rings.polygon.clear(), rings.is_hole.clear(), rings.broken.clear();
  rings.feature = feature.feature;
  const RegionView& regions = feature.layer.regions;
  for (std::uint32_t p = feature.polygon_begin(); p < feature.polygon_end(); ++p) {
    for (std::uint32_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c) {
      if (!append_ring(regions.contour(c), rings, faults, c)) continue;
      const std::size_t begin = rings.begin(rings.size());
      rings.points.push_back(rings.points[begin]);
      rings.vertex.push_back(rings.vertex[begin]);
      rings.ends.push_back(static_cast<std::uint32_t>(rings.points.size()));
      rings.contour.push_back(c);
      rings.polygon.push_back(p);
      rings.is_hole.push_back(c != regions.polygon_begin(p));
      rings.broken.push_back(0);
    }
  }
  if (rings.size() > 1) remove_repeated(rings, faults);
  for (std::uint32_t r = 0; r < rings.size(); ++r) find_spikes(rings, r, faults);
}

}  // namespace oblast::internal::checking
