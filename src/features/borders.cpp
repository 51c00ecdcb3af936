#include "features/borders.h"

#include <algorithm>

#include "base/parallel.h"
#include "base/tuning.h"
#include "result/remove_traces.h"
#include "result/select.h"

namespace oblast::internal {
namespace {

/// The chains with different keys on their sides.
Selection select_borders(const ChainGraph& graph, const FaceLabels& labels, const LabelSets& sets,
                         const KeyRule& rule) {
  Selection selection;
  resize_uninitialized(selection, graph.chains.size());
  for_ranges(selection.size(), tuning::selected_chains_a_task, [&](std::size_t begin, std::size_t end) {
    for (auto c = static_cast<std::uint32_t>(begin); c < end; ++c) {
      const Descriptor d = forward(c);
      const bool border = graph.is_live(c) && !rule.same(sets, labels.left_of(d), labels.right_of(d));
      selection[c] = border ? d : none;
    }
  });
  return selection;
}

class PathFinder {
 public:
  PathFinder(const ChainGraph& graph, const FaceLabels& labels, const Selection& selection)
      : graph_(graph),
        labels_(labels),
        selection_(selection),
        kinds_(classify_nodes(graph, selection)),
        used_(graph.chains.size(), false) {
    resize_uninitialized(place_, 2 * graph.chains.size());
    for (std::uint32_t i = 0; i < graph.lists.size(); ++i) place_[graph.lists[i]] = i;
  }

  Borders run() {
    Steps steps(graph_.lists.size() + graph_.chains.size());
    for (const Descriptor d : graph_.lists) {
      steps();
      if (is_new(d) && is_end(graph_.start_node(d))) add_open(d);
    }
    // What is left has no ends.
    for (std::uint32_t c = 0; c < graph_.chains.size(); ++c) {
      steps();
      if (is_new(forward(c))) add_closed(forward(c));
    }
    return std::move(borders_);
  }

 private:
  bool is_border(Descriptor d) const { return selection_[chain_of(d)] != none; }
  bool is_new(Descriptor d) const { return is_border(d) && !used_[chain_of(d)]; }
  bool is_end(std::uint32_t node) const { return (kinds_.flags[node] & touch_vertex) != 0; }

  void add_open(Descriptor first) {
    begin(first, true);
    borders_.from.push_back({graph_.start_node(first), place_[first]});
    Descriptor d = first;
    for (add_chain(d); !is_end(graph_.end_node(d)); add_chain(d)) d = following(d);
    add_node(graph_.end_node(d), graph_.start_vertex(opposite(d)));
    borders_.to.push_back({graph_.end_node(d), place_[opposite(d)]});
    end();
  }

  void add_closed(Descriptor first) {
    begin(first, false);
    borders_.from.emplace_back();
    borders_.to.emplace_back();
    if (graph_.chains[chain_of(first)].is_loop()) {
      add_chain(first);
    } else {
      for (Descriptor d = first; !used_[chain_of(d)]; d = following(d)) add_chain(d);
    }
    end();
  }

  void begin(Descriptor first, bool open) {
    borders_.paths.open.push_back(open);
    borders_.left.push_back(labels_.left_of(first));
    borders_.right.push_back(labels_.right_of(first));
  }
  void end() { borders_.paths.ends.push_back(checked_index(borders_.paths.points.size(), "vertices of borders")); }

  /// The only other border at the node that a border comes to.
  Descriptor following(Descriptor d) const {
    for (const Descriptor next : graph_.list(graph_.end_node(d)))
      if (is_border(next) && next != opposite(d)) return next;
    return none;
  }

  /// All its vertices but the last.
  void add_chain(Descriptor d) {
    used_[chain_of(d)] = true;
    const Chain& chain = graph_.chains[chain_of(d)];
    std::uint32_t first = chain.first, last = chain.last;
    if (!chain.is_loop()) {
      add_node(graph_.start_node(d), graph_.start_vertex(d));
      is_backward(d) ? --last : ++first;
    }
    Rings& paths = borders_.paths;
    const auto begin = graph_.strands.points.begin();
    if (is_backward(d))
      paths.points.insert(paths.points.end(), std::reverse_iterator(begin + last + 1),
                          std::reverse_iterator(begin + first + 1));
    else
      paths.points.insert(paths.points.end(), begin + first, begin + last);
    paths.flags.resize(paths.points.size(), 0);
  }

  void add_node(std::uint32_t node, std::uint32_t vertex) {
    Rings& paths = borders_.paths;
    const auto at = static_cast<std::uint32_t>(paths.points.size());
    paths.points.push_back(graph_.point(vertex));
    paths.flags.push_back(kinds_.flags[node]);
    if (kinds_.flags[node] & trace_vertex)
      for (const TraceEdge& edge : trace_edges_at(kinds_.trace_edges, node))
        paths.trace_edges.push_back({at, edge.edge});
  }

  const ChainGraph& graph_;
  const FaceLabels& labels_;
  const Selection& selection_;
  NodeKinds kinds_;
  LargeArray<std::uint32_t> place_;  ///< by descriptor, in the lists
  Array<bool> used_;                 ///< by chain
  Borders borders_;
};

}  // namespace

Borders find_borders(const ChainGraph& graph, const FaceLabels& labels, const LabelSets& sets, const KeyRule& rule,
                     CollinearVertices collinear) {
  Borders borders = PathFinder(graph, labels, select_borders(graph, labels, sets, rule)).run();
  borders.paths = remove_traces(std::move(borders.paths), collinear);
  return borders;
}

}  // namespace oblast::internal
