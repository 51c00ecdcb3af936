#include "window/contours.h"

#include <algorithm>
#include <bit>

#include "base/call_memory.h"
#include "base/index.h"
#include "base/memory_budget.h"
#include "engines/leonov_nikitin/label.h"
#include "plane/point_hash.h"
#include "result/assemble.h"
#include "result/link.h"
#include "result/nesting.h"
#include "result/rings.h"

namespace oblast::internal::window {
namespace {

/// Flags every vertex whose point occurs more than once.
void flag_repeated(std::span<const Point> points, Array<std::uint8_t>& flags) {
  Array<std::uint32_t> slots(std::bit_ceil(points.size() * 2 + 2), none);
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    for (std::uint64_t slot = hash(points[v]);; ++slot) {
      std::uint32_t& entry = slots[slot & (slots.size() - 1)];
      if (entry == none) {
        entry = v;
        break;
      }
      if (points[entry] == points[v]) {
        flags[entry] = flags[v] = noding::node_flag;
        break;
      }
    }
  }
}

/// All chains, each with the result on its left.
RegionSet assembled(const ChainGraph& graph) {
  Selection selection(graph.chains.size(), none);
  for (std::uint32_t c = 0; c < selection.size(); ++c)
    if (graph.is_live(c)) selection[c] = forward(c);
  const LinkedContours linked = link(graph, selection, ContourConvention::ogc);
  const Rings rings = contours_to_rings(graph, selection, linked);
  const Nesting nesting = nest(graph, selection, linked, rings);
  const Charge charge(bytes_of_regions(rings.points.size(), rings.size(), nesting.polygon_count));
  return assemble(rings, nesting);
}

}  // namespace

void Contours::close(std::uint32_t polygon) {
  const std::size_t begin = ends_.empty() ? 0 : ends_.back();
  if (points_.size() - begin < 3) {
    points_.resize(begin);
    return;
  }
  ends_.push_back(checked_index(points_.size(), "vertices of the result", most_vertices));
  polygons_.push_back(polygon);
}

RegionSet Contours::single() const {
  const auto smallest = std::min_element(points_.begin(), points_.end(), lexicographically_less);
  const Charge charge(bytes_of_regions(points_.size(), 1, 1));
  RegionSet result;
  result.points.reserve(points_.size());
  result.points.assign(smallest, points_.end());
  result.points.insert(result.points.end(), points_.begin(), smallest);
  result.contour_ends = {static_cast<std::uint32_t>(points_.size())};
  result.polygon_ends = {1};
  return result;
}

/// The contours as they are, without anything labelled. The changes: one in a, and the number of its polygon in b.
ChainGraph Contours::graph(Array<std::uint8_t> flags) const {
  noding::Strands strands;
  std::uint32_t begin = 0;
  for (std::size_t k = 0; k < ends_.size(); ++k) {
    const std::uint32_t end = ends_[k];
    // A closed strand with nodes begins at one.
    std::uint32_t first = begin;
    while (first < end && flags[first] == 0) ++first;
    if (first == end) first = begin;
    const auto add = [&](std::uint32_t v) {
      strands.points.push_back(points_[v]);
      strands.flags.push_back(flags[v]);
    };
    for (std::uint32_t v = first; v < end; ++v) add(v);
    for (std::uint32_t v = begin; v <= first; ++v) add(v);
    strands.close_strand({1, static_cast<std::int32_t>(polygons_[k] + 1)}, noding::any_group);
    begin = end;
  }
  return build_chain_graph(std::move(strands));
}

RegionSet Contours::to_region_set() const {
  if (ends_.empty()) return {};
  Array<std::uint8_t> flags(points_.size(), 0);
  flag_repeated(points_, flags);
  const bool touches = std::find(flags.begin(), flags.end(), noding::node_flag) != flags.end();
  if (ends_.size() == 1 && !touches) return single();
  return assembled(graph(std::move(flags)));
}

// With the rule `polygons` every polygon counts by itself, and a sum of winding numbers may hide two wrong ones: -1 in
// a polygon whose hole was taken for its outer contour, and 1 in another polygon around it. So b sums up the numbers of
// the polygons. From the outside, where nothing is covered, go across one contour after another: while all is regular,
// a is the count of polygons that cover a place, 0 or 1, and b is the number of that one, or 0. A contour is left to
// its right where a is 0 there, and b is 0 there only if it is a contour of that polygon.
std::optional<RegionSet> Contours::to_region_set_if_regular() const {
  if (ends_.empty()) return RegionSet{};
  Array<std::uint8_t> flags(points_.size(), 0);
  flag_repeated(points_, flags);
  const ChainGraph contours = graph(std::move(flags));
  const LargeArray<Winding> right = leonov_nikitin::label(contours);
  for (std::uint32_t c = 0; c < contours.chains.size(); ++c)
    if (!contours.is_live(c) || !right[c].is_zero() || contours.chains[c].change.a != 1) return {};
  return assembled(contours);
}

}  // namespace oblast::internal::window
