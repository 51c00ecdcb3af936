#include "features/face_labels.h"

#include <algorithm>
#include <numeric>

#include "base/disjoint_sets.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "graph/components.h"

namespace oblast::internal {
namespace {

/// By descriptor: the next one of its face cycle.
LargeArray<Descriptor> find_successors(const ChainGraph& graph) {
  LargeArray<Descriptor> next;
  resize_uninitialized(next, 2 * graph.chains.size());
  for (auto c = graph.first_loop; c < graph.chains.size(); ++c) {
    next[forward(c)] = forward(c);
    next[opposite(forward(c))] = opposite(forward(c));
  }
  for_ranges(graph.node_count(), tuning::linked_nodes_a_task, [&](std::size_t begin, std::size_t end) {
    for (auto node = static_cast<std::uint32_t>(begin); node < end; ++node) {
      const auto list = graph.list(node);
      for (std::size_t i = 0; i < list.size(); ++i) next[opposite(list[i])] = list[i == 0 ? list.size() - 1 : i - 1];
    }
  });
  return next;
}

class Labelling {
 public:
  Labelling(const ChainGraph& graph, LabelSets& sets) : graph_(graph), sets_(sets), next_(find_successors(graph)) {}

  FaceLabels run() {
    find_cycles();
    const Components components = find_live_components();
    Array<Outside> outside;
    outside.reserve(components.size());
    for (const Component& component : components.all) outside.push_back(outside_of(graph_, component));
    const Surroundings around = find_surroundings(graph_, components, outside);

    Array<bool> asks(components.size(), false);
    for (const std::uint32_t i : around.asking) asks[i] = true;
    for (std::size_t i = 0; i < components.size(); ++i)
      if (!asks[i]) spread({}, outside[i].side);
    for (std::size_t k = 0; k < around.asking.size(); ++k) {
      const Below& below = around.below[k];
      FaceLabel label;
      if (below.chain != none) {
        const Descriptor d = forward(below.chain);
        label = labels_.of_cycle[labels_.cycle[below.rightward ? d : opposite(d)]];
      }
      spread(label, outside[around.asking[k]].side);
    }
    keep_members();
    return std::move(labels_);
  }

 private:
  void find_cycles() {
    fill_in_large_pages(labels_.cycle, next_.size(), none);
    Steps steps(next_.size());
    for (Descriptor first = 0; first < next_.size(); ++first) {
      steps();
      if (labels_.cycle[first] != none || !graph_.is_live(chain_of(first))) continue;
      const auto cycle = static_cast<std::uint32_t>(first_of_cycle_.size());
      first_of_cycle_.push_back(first);
      for (Descriptor d = first; labels_.cycle[d] == none; d = next_[d]) labels_.cycle[d] = cycle;
    }
  }

  Components find_live_components() const {
    DisjointSets sets(graph_.node_count());
    for (std::uint32_t c = 0; c < graph_.first_loop; ++c)
      if (graph_.is_live(c)) sets.unite(graph_.chains[c].from, graph_.chains[c].to);
    Array<std::uint32_t> component(graph_.node_count(), none);
    std::uint32_t count = 0;
    for (std::uint32_t node = 0; node < component.size(); ++node) {
      if (graph_.list(node).empty()) continue;
      const std::uint32_t root = sets.find(node);
      if (component[root] == none) component[root] = count++;
      component[node] = component[root];
    }
    return find_components(graph_, component, count);
  }

  /// Gives the cycle on the left of `start` its label, and all cycles of the same component theirs.
  void spread(FaceLabel label, Descriptor start) {
    labels_.of_cycle.resize(first_of_cycle_.size());
    reached_.resize(first_of_cycle_.size(), false);
    reach(labels_.cycle[start], label);
    Steps steps;
    while (!waiting_.empty()) {
      const std::uint32_t cycle = waiting_.back();
      waiting_.pop_back();
      const FaceLabel here = labels_.of_cycle[cycle];
      const Descriptor first = first_of_cycle_[cycle];
      Descriptor d = first;
      do {
        steps();
        const std::uint32_t across = labels_.cycle[opposite(d)];
        if (!reached_[across]) reach(across, crossed(here, -graph_.change(d)));
        d = next_[d];
      } while (d != first);
    }
  }

  void reach(std::uint32_t cycle, FaceLabel label) {
    labels_.of_cycle[cycle] = label;
    reached_[cycle] = true;
    waiting_.push_back(cycle);
  }

  FaceLabel crossed(FaceLabel label, Winding change) {
    const noding::SourceChanges& sources = *graph_.strands.rules.sources;
    sources.for_each(
        change.a, [&](std::uint32_t source, std::int32_t count) { label.a = sets_.a.changed(label.a, source, count); });
    sources.for_each(
        change.b, [&](std::uint32_t source, std::int32_t count) { label.b = sets_.b.changed(label.b, source, count); });
    return label;
  }

  void keep_members() {
    Steps steps(labels_.of_cycle.size());
    for (FaceLabel& label : labels_.of_cycle) {
      steps();
      label = {sets_.a.members(label.a), sets_.b.members(label.b)};
    }
  }

  const ChainGraph& graph_;
  LabelSets& sets_;
  LargeArray<Descriptor> next_;
  FaceLabels labels_;
  Array<Descriptor> first_of_cycle_;
  Array<bool> reached_;  ///< by cycle
  Array<std::uint32_t> waiting_;
};

}  // namespace

FaceLabels label_faces(const ChainGraph& graph, LabelSets& sets) { return Labelling(graph, sets).run(); }

}  // namespace oblast::internal
