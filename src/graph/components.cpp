#include "graph/components.h"

#include <algorithm>

#include "base/large_pages.h"
#include "base/parallel.h"
#include "exact/orientation.h"
#include "plane/enclosing_boxes.h"
#include "plane/smallest_vertex.h"

namespace oblast::internal {
namespace {

Box box_of(const LargeArray<Point>& points, const Chain& chain) {
  Box box = Box::of(points[chain.first], points[chain.last]);
  for (std::uint32_t v = chain.first + 1; v < chain.last; ++v) box = box.joined(points[v]);
  return box;
}

class ComponentFinder {
 public:
  ComponentFinder(const ChainGraph& graph, std::span<const std::uint32_t> component_of_node, std::uint32_t count)
      : graph_(graph), component_of_node_(component_of_node) {
    components_.all.resize(count);
    components_.boxes.resize(count);
    fill_in_large_pages(components_.of_chain, graph.chains.size(), none);
  }

  Components run() {
    const std::size_t chains_a_range = grain(graph_.chains.size(), graph_.strands.points.size());
    Array<Array<Part>> parts(range_count(graph_.chains.size(), chains_a_range));
    for_numbered_ranges(graph_.chains.size(), chains_a_range,
                        [&](std::size_t i, std::size_t begin, std::size_t end) { parts[i] = parts_of(begin, end); });
    for (const Array<Part>& range : parts)
      for (const Part& part : range) add(part);
    return std::move(components_);
  }

 private:
  /// What chains that follow one another have of a component.
  struct Part {
    std::uint32_t component;  ///< none for a contour that meets nothing
    std::uint32_t chain;      ///< a chain that the smallest vertex is on
    Box box;
    std::uint32_t smallest = none;  ///< that vertex
  };

  Array<Part> parts_of(std::size_t begin, std::size_t end) {
    Array<Part> parts;
    for (auto c = static_cast<std::uint32_t>(begin); c < end; ++c) {
      graph_.fetch_points_ahead(c);
      if (!graph_.is_live(c)) continue;
      const Chain& chain = graph_.chains[c];
      const Box box = box_of(graph_.strands.points, chain);
      const std::uint32_t component = components_.of_chain[c] = chain.is_loop() ? none : component_of_node_[chain.from];
      if (component == none || parts.empty() || parts.back().component != component) {
        parts.push_back({component, c, box});
        continue;
      }
      Part& part = parts.back();
      // Chains come in no order along x, so more than this is hard to predict.
      if (box.x0 < part.box.x0 || (box.x0 == part.box.x0 && is_smaller(smallest_of(c), smallest_of(part.chain))))
        part.chain = c;
      part.box = part.box.joined(box);
    }
    for (Part& part : parts) part.smallest = smallest_of(part.chain);
    return parts;
  }

  void add(const Part& part) {
    if (part.component == none) {
      components_.of_chain[part.chain] = static_cast<std::uint32_t>(components_.all.size());
      components_.all.push_back({part.chain, part.smallest});
      components_.boxes.push_back(part.box);
      return;
    }
    Component& component = components_.all[part.component];
    Box& box = components_.boxes[part.component];
    box = component.chain == none ? part.box : box.joined(part.box);
    if (component.chain == none || is_smaller(part.smallest, component.vertex)) component = {part.chain, part.smallest};
  }

  std::uint32_t smallest_of(std::uint32_t c) const {
    const Chain& chain = graph_.chains[c];
    const auto vertices = std::span(graph_.strands.points).subspan(chain.first, chain.last + 1 - chain.first);
    return chain.first + smallest_vertex(vertices).vertex;
  }

  bool is_smaller(std::uint32_t vertex, std::uint32_t other) const {
    return lexicographically_less(graph_.point(vertex), graph_.point(other));
  }

  const ChainGraph& graph_;
  std::span<const std::uint32_t> component_of_node_;
  Components components_;
};

}  // namespace

Components find_components(const ChainGraph& graph, std::span<const std::uint32_t> component_of_node,
                           std::uint32_t count) {
  return ComponentFinder(graph, component_of_node, count).run();
}

Outside outside_of(const ChainGraph& graph, const Component& component) {
  const std::uint32_t v = component.vertex;
  const Chain& chain = graph.chains[component.chain];
  const Point& p = graph.point(v);
  if (!chain.is_loop() && (v == chain.first || v == chain.last)) {
    // At a smallest node the outside follows the last descriptor (angular_order.h).
    const auto list = graph.list(v == chain.first ? chain.from : chain.to);
    return {{p, graph.point(graph.next_vertex(list.front()))}, list.back()};
  }
  const Point& before = graph.point(v == chain.first ? chain.last - 1 : v - 1);
  const Point& after = graph.point(v + 1 > chain.last ? chain.first + 1 : v + 1);
  // A left turn at the smallest vertex has the outside on its right, and its second edge is the lower.
  const bool left_turn = exact::orientation(before, p, after) > 0;
  const Descriptor along = forward(component.chain);
  return {{p, left_turn ? after : before}, left_turn ? opposite(along) : along};
}

Surroundings find_surroundings(const ChainGraph& graph, const Components& components,
                               std::span<const Outside> outside) {
  const auto count = static_cast<std::uint32_t>(components.size());
  Surroundings found;
  if (count <= 1) return found;
  Array<Point> smallest;
  smallest.reserve(count);
  for (const Outside& o : outside) smallest.push_back(o.query.p);
  const Enclosure enclosure = find_enclosing(components.boxes, smallest);
  for (std::uint32_t i = 0; i < count; ++i)
    if (enclosure.enclosed[i]) found.asking.push_back(i);
  parallel_sort(found.asking.begin(), found.asking.end(),
                [&](std::uint32_t i, std::uint32_t j) { return lexicographically_less(smallest[i], smallest[j]); });
  Array<BelowQuery> queries;
  queries.reserve(found.asking.size());
  for (const std::uint32_t i : found.asking) queries.push_back(outside[i].query);
  Array<std::uint32_t> chains;
  if (!found.asking.empty()) {
    const auto& of_chain = components.of_chain;
    for (std::uint32_t c = 0; c < of_chain.size(); ++c)
      if (of_chain[c] != none && enclosure.encloses[of_chain[c]] != 0) chains.push_back(c);
  }
  found.below = locate_below(graph, chains, queries);
  return found;
}

}  // namespace oblast::internal
