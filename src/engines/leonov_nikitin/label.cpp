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
#include "overlay/locate_below.h"

namespace oblast::leonov_nikitin {
namespace {

struct Component {
  BelowQuery smallest;  ///< its smallest vertex, and the lower of the edges there
  Winding outside;      ///< winding numbers of the sector outside it, relative to its first sector
};

class Labelling {
 public:
  explicit Labelling(const ChainGraph& graph)
      : graph_(graph),
        right_(graph.chains.size()),
        component_of_(graph.chains.size(), none),
        visited_(graph.node_count(), false) {}

  std::vector<Winding> run() {
    const auto chain_count = static_cast<std::uint32_t>(graph_.chains.size());
    for (std::uint32_t c = 0; c < chain_count; ++c) {
      if (!graph_.is_live(c)) continue;
      live_.push_back(c);
      if (component_of_[c] == none) label_component(c);
    }
    settle_components();
    return std::move(right_);
  }

 private:
  /// Steps 1 and 2, from a first chain whose right side is taken as zero.
  void label_component(std::uint32_t first_chain) {
    const auto component = static_cast<std::uint32_t>(components_.size());
    const Chain& chain = graph_.chains[first_chain];
    components_.push_back({{graph_.point(chain.first), graph_.point(chain.first + 1)}, {}});
    visit_chain(first_chain, component, {});
    if (chain.is_loop()) return;
    pending_.push_back(forward(first_chain));
    pending_.push_back(opposite(forward(first_chain)));
    while (!pending_.empty()) {
      const Descriptor known = pending_.back();
      pending_.pop_back();
      label_around(known, component);
    }
  }

  /// Step 1: goes around the start node of a descriptor whose chain has its label.
  void label_around(Descriptor known, std::uint32_t component) {
    const std::uint32_t node = graph_.start_node(known);
    if (visited_[node]) return;
    visited_[node] = true;
    const auto list = graph_.list(node);
    const auto at = static_cast<std::size_t>(std::find(list.begin(), list.end(), known) - list.begin());
    Winding sector = left_of(known);
    for (std::size_t i = at + 1; i < at + list.size(); ++i) {
      const Descriptor d = list[i % list.size()];
      // The sector lies to the right of d as d leaves the node.
      if (component_of_[chain_of(d)] == none) {
        const Winding change = graph_.change(d);
        visit_chain(chain_of(d), component, is_backward(d) ? sector + change : sector);
        pending_.push_back(opposite(d));
      }
      sector = left_of(d);
    }
    note_smallest_node(list, component);
  }

  Winding left_of(Descriptor d) const {
    const Winding right = right_[chain_of(d)];
    return is_backward(d) ? right : right + graph_.change(d);
  }

  /// Labels a chain, and looks whether the component's smallest vertex is inside it.
  void visit_chain(std::uint32_t c, std::uint32_t component, Winding right) {
    right_[c] = right;
    component_of_[c] = component;
    const Chain& chain = graph_.chains[c];
    Component& found = components_[component];
    std::uint32_t smallest = none;
    const std::uint32_t begin = chain.is_loop() ? chain.first : chain.first + 1;
    for (std::uint32_t v = begin; v < chain.last; ++v) {
      const Point& best = smallest == none ? found.smallest.p : graph_.point(smallest);
      if (lexicographically_less(graph_.point(v), best) || (smallest == none && graph_.point(v) == best)) smallest = v;
    }
    if (smallest == none) return;
    const Point& p = graph_.point(smallest);
    const Point& before = graph_.point(smallest == chain.first ? chain.last - 1 : smallest - 1);
    const Point& after = graph_.point(smallest + 1);
    const bool left_turn = exact::orientation(before, p, after) > 0;
    // A left turn at the smallest vertex has the outside on its right, and its second edge is the lower.
    found.smallest = {p, left_turn ? after : before};
    found.outside = left_turn ? right : right + chain.change;
  }

  void note_smallest_node(std::span<const Descriptor> list, std::uint32_t component) {
    Component& found = components_[component];
    const Point& x = graph_.point(graph_.start_vertex(list[0]));
    if (lexicographically_less(found.smallest.p, x)) return;
    found.smallest = {x, graph_.point(graph_.next_vertex(list[0]))};
    found.outside = left_of(list[list.size() - 1]);
  }

  /// Step 3.
  void settle_components() {
    std::vector<BelowQuery> queries;
    queries.reserve(components_.size());
    for (const Component& c : components_) queries.push_back(c.smallest);
    const std::vector<Below> below = locate_below(graph_, live_, queries);

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
  std::vector<std::uint32_t> component_of_;
  std::vector<bool> visited_;  ///< by node
  std::vector<Component> components_;
  std::vector<std::uint32_t> live_;
  std::vector<Descriptor> pending_;
};

}  // namespace

std::vector<Winding> label(const ChainGraph& graph) { return Labelling(graph).run(); }

}  // namespace oblast::leonov_nikitin
