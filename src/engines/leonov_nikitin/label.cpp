// Steps, after the paper's section 3, with winding numbers in place of its four edge labels:
//   1. Around a vertex x the descriptors of L(x) cut the neighbourhood into sectors. Crossing a
//      descriptor changes the winding numbers by its change, so one sector gives all (the paper's
//      marking sectors).
//   2. A chain carries its label to its other end (rule 2.1). So everything connected is labelled
//      relative to one sector.
//   3. Each component, and each contour that meets nothing, needs one point-in-region query: which
//      chain lies directly below its smallest vertex. That chain's component has a smaller smallest
//      vertex, so in the order of smallest vertices it is settled already.
#include "engines/leonov_nikitin/label.h"

#include <algorithm>
#include <numeric>

#include "exact/orientation.h"
#include "memory/large_pages.h"
#include "overlay/locate_below.h"

namespace oblast::leonov_nikitin {
namespace {

/// What is connected. Its labels are relative to the sector before the first descriptor of its first node.
struct Component {
  std::uint32_t chain;   ///< a chain that its smallest vertex is on
  std::uint32_t vertex;  ///< that vertex
  Winding outside;       ///< winding numbers of the sector outside it
};

class Labelling {
 public:
  explicit Labelling(const ChainGraph& graph) : graph_(graph) {
    resize_in_large_pages(right_, graph.chains.size());
    resize_in_large_pages(component_of_, graph.chains.size(), none);
    resize_in_large_pages(component_of_node_, graph.node_count(), none);
  }

  std::vector<Winding> run() {
    label_chains();
    find_smallest_vertices();
    settle_components();
    return std::move(right_);
  }

 private:
  /// Steps 1 and 2.
  void label_chains() {
    std::uint32_t component = 0;
    for (std::uint32_t node = 0; node < graph_.node_count(); ++node) {
      if (component_of_node_[node] != none || graph_.list(node).empty()) continue;
      component_of_node_[node] = component;
      label_around(node, graph_.list(node)[0], {}, component);
      // First in, first out: what is at hand soon is known long enough before to be fetched.
      for (std::size_t i = 0; i < pending_.size(); ++i) {
        fetch_ahead(i);
        const Descriptor known = pending_[i];
        const Winding right = right_[chain_of(known)];
        label_around(graph_.start_node(known), known,
                     is_backward(known) ? right + graph_.change(opposite(known)) : right, component);
      }
      pending_.clear();
      ++component;
    }
    components_.resize(component, {none, none, {}});
  }

  void fetch_ahead(std::size_t i) const {
    constexpr std::size_t chain_ahead = 12, node_ahead = 8, list_ahead = 4;
    if (i + chain_ahead < pending_.size()) __builtin_prefetch(&graph_.chains[chain_of(pending_[i + chain_ahead])]);
    if (i + node_ahead < pending_.size())
      __builtin_prefetch(&graph_.list_ends[graph_.start_node(pending_[i + node_ahead])]);
    if (i + list_ahead < pending_.size())
      __builtin_prefetch(graph_.list(graph_.start_node(pending_[i + list_ahead])).data());
  }

  /// Step 1: goes around a node from a descriptor, given the winding numbers right of it as it leaves the node. Step 2:
  /// on to nodes not seen yet.
  void label_around(std::uint32_t node, Descriptor known, Winding sector, std::uint32_t component) {
    const auto list = graph_.list(node);
    const auto at = static_cast<std::size_t>(std::find(list.begin(), list.end(), known) - list.begin());
    for (std::size_t i = at; i < at + list.size(); ++i) {
      const Descriptor d = list[i < list.size() ? i : i - list.size()];
      const Chain& chain = graph_.chains[chain_of(d)];
      const Winding left = is_backward(d) ? sector - chain.change : sector + chain.change;
      right_[chain_of(d)] = is_backward(d) ? left : sector;
      sector = left;
      const std::uint32_t other = is_backward(d) ? chain.from : chain.to;
      if (component_of_node_[other] != none) continue;
      component_of_node_[other] = component;
      pending_.push_back(opposite(d));
    }
  }

  /// Of each component, and of each contour that meets nothing, which is one by itself: among the nodes and among the
  /// vertices between them.
  void find_smallest_vertices() {
    const auto note = [&](std::uint32_t component, std::uint32_t chain, std::uint32_t vertex) {
      Component& found = components_[component];
      if (found.vertex == none || lexicographically_less(graph_.point(vertex), graph_.point(found.vertex)))
        found = {chain, vertex, {}};
    };
    for (std::uint32_t node = 0; node < graph_.node_count(); ++node) {
      if (component_of_node_[node] == none) continue;
      const Descriptor first = graph_.list(node)[0];
      note(component_of_node_[node], chain_of(first), graph_.start_vertex(first));
    }
    const auto chain_count = static_cast<std::uint32_t>(graph_.chains.size());
    live_.reserve(chain_count);
    for (std::uint32_t c = 0; c < chain_count; ++c) {
      if (!graph_.is_live(c)) continue;
      live_.push_back(c);
      const Chain& chain = graph_.chains[c];
      component_of_[c] =
          chain.is_loop() ? static_cast<std::uint32_t>(components_.size()) : component_of_node_[chain.from];
      if (chain.is_loop()) components_.push_back({c, chain.first, {}});
      for (std::uint32_t v = chain.first + 1; v < chain.last; ++v) note(component_of_[c], c, v);
    }
  }

  /// The smallest vertex of a component with the lower of the edges there, and the sector outside it.
  BelowQuery look_outside(Component& component) const {
    const std::uint32_t v = component.vertex;
    const Chain& chain = graph_.chains[component.chain];
    const Winding right = right_[component.chain];
    const Point& p = graph_.point(v);
    if (!chain.is_loop() && (v == chain.first || v == chain.last)) {
      // At a smallest node the outside follows the last descriptor (angular_order.h).
      const auto list = graph_.list(v == chain.first ? chain.from : chain.to);
      component.outside = left_of(list.back());
      return {p, graph_.point(graph_.next_vertex(list.front()))};
    }
    const Point& before = graph_.point(v == chain.first ? chain.last - 1 : v - 1);
    const Point& after = graph_.point(v + 1);
    // A left turn at the smallest vertex has the outside on its right, and its second edge is the lower.
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
    std::vector<BelowQuery> queries;
    queries.reserve(components_.size());
    for (Component& c : components_) queries.push_back(look_outside(c));
    // Below the smallest vertex of all there is nothing.
    const std::vector<Below> below = queries.size() == 1 ? std::vector<Below>(1) : locate_below(graph_, live_, queries);

    std::vector<std::uint32_t> order(components_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t i, std::uint32_t j) { return lexicographically_less(queries[i].p, queries[j].p); });
    std::vector<Winding> base(components_.size());
    for (const std::uint32_t i : order) {
      const Below& b = below[i];
      Winding outside;
      if (b.chain != none) {
        outside = right_[b.chain] + base[component_of_[b.chain]];
        if (b.rightward) outside = outside + graph_.chains[b.chain].change;
      }
      base[i] = outside - components_[i].outside;
    }
    for (const std::uint32_t c : live_) right_[c] = right_[c] + base[component_of_[c]];
  }

  const ChainGraph& graph_;
  std::vector<Winding> right_;
  std::vector<std::uint32_t> component_of_;  ///< by chain
  std::vector<std::uint32_t> component_of_node_;
  std::vector<Component> components_;
  std::vector<std::uint32_t> live_;
  std::vector<Descriptor> pending_;
};

}  // namespace

std::vector<Winding> label(const ChainGraph& graph) { return Labelling(graph).run(); }

}  // namespace oblast::leonov_nikitin
