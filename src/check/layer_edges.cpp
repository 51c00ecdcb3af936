#include "check/layer_edges.h"

#include <algorithm>

#include "base/parallel.h"

namespace oblast::internal::checking {

LayerEdges::LayerEdges(const FeatureView& features) {
  const RegionView& regions = features.regions;
  const std::size_t most = regions.points.size() + regions.contour_count();
  strands_.points.reserve(most);
  vertex_.reserve(most);
  Steps steps(features.feature_count());
  for (std::uint32_t f = 0; f < features.feature_count(); ++f) {
    steps();
    const std::uint32_t begin = features.feature_begin(f), end = features.feature_end(f);
    if (begin == end) continue;
    for (std::uint32_t c = regions.polygon_begin(begin); c < regions.polygon_end(end - 1); ++c) {
      const std::span<const Point> contour = regions.contour(c);
      const std::size_t first = strands_.points.size();
      for (std::uint32_t v = 0; v < contour.size(); ++v) {
        if (contour[v] == contour[v + 1 < contour.size() ? v + 1 : 0]) continue;
        strands_.points.push_back({contour[v].x + 0.0, contour[v].y + 0.0});
        vertex_.push_back(v);
      }
      if (strands_.points.size() - first < 3) {
        strands_.points.resize(first);
        vertex_.resize(first);
        continue;
      }
      strands_.points.push_back(Point(strands_.points[first]));
      vertex_.push_back(vertex_[first]);
      strands_.close_strand({1, 0}, f + 1);
      contour_.push_back(c);
      feature_.push_back(f);
    }
  }
  strands_.flags.assign(strands_.points.size(), 0);
  for (std::size_t s = 0; s < strands_.size(); ++s)
    strands_.flags[strands_.begin(s)] = strands_.flags[strands_.ends[s] - 1] = noding::closed_flag;
}

FeaturePlace LayerEdges::place(std::uint32_t index) const {
  const std::size_t strand = strands_.strand_of(index);
  return {feature_[strand], contour_[strand], vertex_[index]};
}

void LayerEdges::sort() {
  order_.reserve(strands_.points.size());
  for (std::size_t s = 0; s < strands_.size(); ++s)
    for (std::uint32_t i = strands_.begin(s); i + 1 < strands_.ends[s]; ++i) order_.push_back(i);
  const Point* const p = points();
  parallel_sort(order_.begin(), order_.end(), [p](std::uint32_t i, std::uint32_t j) {
    return p[i] == p[j] ? i < j : lexicographically_less(p[i], p[j]);
  });
}

std::span<const std::uint32_t> LayerEdges::at(const Point& q) const {
  const Point* const p = points();
  const auto first = std::lower_bound(order_.begin(), order_.end(), q, [p](std::uint32_t i, const Point& at) {
    return lexicographically_less(p[i], at);
  });
  auto past = first;
  while (past != order_.end() && p[*past] == q) ++past;
  return {first, past};
}

}  // namespace oblast::internal::checking
