// Steps, after the paper's section 3, with winding numbers in place of its four edge labels:
//   1. The descriptors of L(x) divide the neighbourhood of a vertex x into sectors. Crossing a descriptor changes the
//      winding numbers by its change. So one sector determines all of them (the paper's marking sectors).
//   2. A chain carries its label to its other end (rule 2.1). So everything that is connected is labelled relative to
//   one
//      sector (relative_labels.h).
//   3. Each component, and each contour that meets nothing, needs one point-in-region query: which chain lies directly
//      below its smallest vertex? The component of that chain has a smaller smallest vertex. So in the order of
//      smallest vertices it is labelled already. If the smallest vertex of a component is in the box of no other
//      component, nothing surrounds it, and no query is needed. If the box of a component contains no such vertex, it
//      surrounds nothing, and queries ignore it: a line that passes through it leaves it with the winding numbers with
//      which it entered.
#include "engines/leonov_nikitin/label.h"

#include <algorithm>

#include "base/large_pages.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "engines/leonov_nikitin/relative_labels.h"
#include "exact/orientation.h"
#include "graph/locate_below.h"
#include "plane/enclosing_boxes.h"
#include "plane/smallest_vertex.h"

namespace oblast::internal::leonov_nikitin {
namespace {

/// A connected component. Its labels are relative to one of its sectors.
struct Component {
  std::uint32_t chain = none;   ///< a chain that contains its smallest vertex
  std::uint32_t vertex = none;  ///< that vertex
  Winding outside = {};         ///< winding numbers of the sector outside it
};

Box box_of(const LargeArray<Point>& points, const Chain& chain) {
  Box box = Box::of(points[chain.first], points[chain.last]);
  for (std::uint32_t v = chain.first + 1; v < chain.last; ++v) box = box.joined(points[v]);
  return box;
}

class Labelling {
 public:
  explicit Labelling(const ChainGraph& graph) : graph_(graph) {}

  LargeArray<Winding> run() {
    RelativeLabels labels = label_relatively(graph_);
    right_ = std::move(labels.right);
    find_components(labels);
    settle_components();
    return std::move(right_);
  }

 private:
  /// The part of a component in consecutive chains.
  struct Part {
    std::uint32_t component;  ///< none for a contour that meets nothing
    std::uint32_t chain;      ///< a chain that contains the smallest vertex
    Box box;
    std::uint32_t smallest = none;  ///< that vertex
  };

  /// Finds the components. A contour that meets nothing is a component, too.
  void find_components(const RelativeLabels& labels) {
    components_.resize(labels.component_count);
    boxes_.resize(labels.component_count);
    fill_in_large_pages(component_of_, graph_.chains.size(), none);
    const std::size_t chains_a_range = grain(graph_.chains.size(), graph_.strands.points.size());
    Array<Array<Part>> parts(range_count(graph_.chains.size(), chains_a_range));
    for_numbered_ranges(graph_.chains.size(), chains_a_range, [&](std::size_t i, std::size_t begin, std::size_t end) {
      parts[i] = parts_of(begin, end, labels);
    });
    for (const Array<Part>& range : parts)
      for (const Part& part : range) add(part);
  }

  Array<Part> parts_of(std::size_t begin, std::size_t end, const RelativeLabels& labels) {
    Array<Part> parts;
    for (auto c = static_cast<std::uint32_t>(begin); c < end; ++c) {
      graph_.fetch_points_ahead(c);
      if (!graph_.is_live(c)) continue;
      const Chain& chain = graph_.chains[c];
      const Box box = box_of(graph_.strands.points, chain);
      const std::uint32_t component = component_of_[c] = chain.is_loop() ? none : labels.component[chain.from];
      if (component == none || parts.empty() || parts.back().component != component) {
        parts.push_back({component, c, box});
        continue;
      }
      Part& part = parts.back();
      // Chains are not sorted along x, so the processor predicts only this comparison well.
      if (box.x0 < part.box.x0 || (box.x0 == part.box.x0 && is_smaller(smallest_of(c), smallest_of(part.chain))))
        part.chain = c;
      part.box = part.box.joined(box);
    }
    for (Part& part : parts) part.smallest = smallest_of(part.chain);
    return parts;
  }

  void add(const Part& part) {
    if (part.component == none) {
      component_of_[part.chain] = static_cast<std::uint32_t>(components_.size());
      components_.push_back({part.chain, part.smallest});
      boxes_.push_back(part.box);
      return;
    }
    Component& component = components_[part.component];
    Box& box = boxes_[part.component];
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

  /// The smallest vertex of a component, the lower edge there, and the sector outside.
  BelowQuery look_outside(Component& component) const {
    const std::uint32_t v = component.vertex;
    const Chain& chain = graph_.chains[component.chain];
    const Winding right = right_[component.chain];
    const Point& p = graph_.point(v);
    if (!chain.is_loop() && (v == chain.first || v == chain.last)) {
      // At a smallest node, the sector outside follows the last descriptor (angular_order.h).
      const auto list = graph_.list(v == chain.first ? chain.from : chain.to);
      component.outside = left_of(list.back());
      return {p, graph_.point(graph_.next_vertex(list.front()))};
    }
    const Point& before = graph_.point(v == chain.first ? chain.last - 1 : v - 1);
    const Point& after = graph_.point(v + 1 > chain.last ? chain.first + 1 : v + 1);
    // At a left turn at the smallest vertex, the outside is on the right, and the second edge is the lower one.
    const bool left_turn = exact::orientation(before, p, after) > 0;
    component.outside = left_turn ? right : right + chain.change;
    return {p, left_turn ? after : before};
  }

  Winding left_of(Descriptor d) const {
    const Winding right = right_[chain_of(d)];
    return is_backward(d) ? right : right + graph_.change(d);
  }

  /// Step 3.
  void settle_components() {
    const auto count = static_cast<std::uint32_t>(components_.size());
    Array<BelowQuery> outside;
    Array<Point> smallest;
    outside.reserve(count);
    smallest.reserve(count);
    Steps steps(count);
    for (Component& c : components_) {
      steps();
      outside.push_back(look_outside(c));
      smallest.push_back(outside.back().p);
    }
    if (count == 1) {
      add_to_labels([&](std::uint32_t) { return -components_[0].outside; });
      return;
    }
    const Enclosure enclosure = find_enclosing(boxes_, smallest);

    Array<std::uint32_t> asking;
    for (std::uint32_t i = 0; i < count; ++i)
      if (enclosure.enclosed[i]) asking.push_back(i);
    parallel_sort(asking.begin(), asking.end(),
                  [&](std::uint32_t i, std::uint32_t j) { return lexicographically_less(smallest[i], smallest[j]); });
    Array<BelowQuery> queries;
    queries.reserve(asking.size());
    for (const std::uint32_t i : asking) queries.push_back(outside[i]);
    Array<std::uint32_t> chains;
    if (!asking.empty()) {
      for (std::uint32_t c = 0; c < component_of_.size(); ++c)
        if (component_of_[c] != none && enclosure.encloses[component_of_[c]] != 0) chains.push_back(c);
    }
    const Array<Below> below = locate_below(graph_, chains, queries);

    Array<Winding> base(count);
    for (std::uint32_t i = 0; i < count; ++i) base[i] = -components_[i].outside;
    for (std::size_t k = 0; k < asking.size(); ++k) {
      const Below& b = below[k];
      if (b.chain == none) continue;
      const Winding around = right_[b.chain] + base[component_of_[b.chain]];
      base[asking[k]] = base[asking[k]] + (b.rightward ? around + graph_.chains[b.chain].change : around);
    }
    add_to_labels([&](std::uint32_t component) { return base[component]; });
  }

  /// Adds base(component) to the labels of each component.
  template <class Base>
  void add_to_labels(const Base& base) {
    for_ranges(right_.size(), tuning::labelled_elements_a_task, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c)
        if (component_of_[c] != none) right_[c] = right_[c] + base(component_of_[c]);
    });
  }

  const ChainGraph& graph_;
  LargeArray<Winding> right_;
  LargeArray<std::uint32_t> component_of_;  ///< by chain; none if it is not live
  Array<Component> components_;
  Array<Box> boxes_;  ///< by component
};

}  // namespace

LargeArray<Winding> label(const ChainGraph& graph) { return Labelling(graph).run(); }

}  // namespace oblast::internal::leonov_nikitin
