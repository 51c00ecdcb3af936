#include "overlay/rings.h"

#include <algorithm>

namespace oblast {

Rings contours_to_rings(const ChainGraph& graph, const Selection& selection, const LinkedContours& linked) {
  const std::vector<std::uint8_t> node_flags = classify_nodes(graph, selection);
  Rings rings;
  std::size_t size = 0;
  for (const Descriptor d : linked.descriptors)
    size += graph.chains[chain_of(d)].last - graph.chains[chain_of(d)].first;
  rings.points.reserve(size);
  rings.flags.reserve(size);
  rings.ends.reserve(linked.ends.size());
  for (std::size_t c = 0; c < linked.ends.size(); ++c) {
    for (const Descriptor d : linked.contour(c)) {
      const Chain& chain = graph.chains[chain_of(d)];
      const auto first = graph.strands.points.begin() + chain.first, last = graph.strands.points.begin() + chain.last;
      if (is_backward(d))
        rings.points.insert(rings.points.end(), std::reverse_iterator(last + 1), std::reverse_iterator(first + 1));
      else
        rings.points.insert(rings.points.end(), first, last);
      rings.flags.push_back(chain.is_loop() ? std::uint8_t{0} : node_flags[graph.start_node(d)]);
      rings.flags.resize(rings.points.size(), 0);
    }
    rings.ends.push_back(static_cast<std::uint32_t>(rings.points.size()));
  }
  return rings;
}

}  // namespace oblast
