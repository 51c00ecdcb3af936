// Steps, after the paper's section 3, with winding numbers in place of its four edge labels:
//   1. Around a vertex x the descriptors of L(x) cut the neighbourhood into sectors. Crossing a
//      descriptor changes the winding numbers by its change, so one sector gives all (the paper's
//      marking sectors).
//   2. A chain carries its label to its other end (rule 2.1). So everything connected is labelled
//      relative to one sector (relative_labels.h).
//   3. Each component, and each contour that meets nothing, needs one point-in-region query: which
//      chain lies directly below its smallest vertex (graph/components.h).
#include "engines/leonov_nikitin/label.h"

#include "base/large_pages.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "engines/leonov_nikitin/relative_labels.h"
#include "graph/components.h"

namespace oblast::internal::leonov_nikitin {
namespace {

/// By component: what is to be added to its labels, which are relative to one of its sectors.
Array<Winding> labels_around(const ChainGraph& graph, const Components& components, const LargeArray<Winding>& right) {
  Array<Outside> outside;
  Array<Winding> base;
  outside.reserve(components.size());
  base.reserve(components.size());
  Steps steps(components.size());
  for (const Component& component : components.all) {
    steps();
    const Outside o = outside_of(graph, component);
    const Winding on_right = right[chain_of(o.side)];
    base.push_back(is_backward(o.side) ? -on_right : -(on_right + graph.change(o.side)));
    outside.push_back(o);
  }
  const Surroundings around = find_surroundings(graph, components, outside);
  for (std::size_t k = 0; k < around.asking.size(); ++k) {
    const Below& below = around.below[k];
    if (below.chain == none) continue;
    const Winding on_right = right[below.chain] + base[components.of_chain[below.chain]];
    const Winding above = below.rightward ? on_right + graph.chains[below.chain].change : on_right;
    base[around.asking[k]] = base[around.asking[k]] + above;
  }
  return base;
}

}  // namespace

LargeArray<Winding> label(const ChainGraph& graph) {
  RelativeLabels labels = label_relatively(graph);
  const Components components = find_components(graph, labels.component, labels.component_count);
  LargeArray<Winding> right = std::move(labels.right);
  const Array<Winding> base = labels_around(graph, components, right);
  const auto& component_of = components.of_chain;
  for_ranges(right.size(), tuning::labelled_elements_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
      if (component_of[c] != none) right[c] = right[c] + base[component_of[c]];
  });
  return right;
}

}  // namespace oblast::internal::leonov_nikitin
