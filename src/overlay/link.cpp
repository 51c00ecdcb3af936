#include "overlay/link.h"

#include <algorithm>

#include "memory/large_pages.h"
#include "parallel/for_ranges.h"

namespace oblast {
namespace {

class Linker {
 public:
  Linker(const ChainGraph& graph, const Selection& selection, ContourConvention convention)
      : graph_(graph), selection_(selection), convention_(convention) {
    resize_in_large_pages(next_, graph.chains.size(), none);
  }

  LinkedContours run() {
    find_successors();
    resize_in_large_pages(linked_.walk_of_chain, graph_.chains.size(), none);
    if (convention_ == ContourConvention::ogc) resize_in_large_pages(place_on_path_, graph_.node_count(), none);
    // By node: walks that begin near each other in the plane have their chains near each other in memory.
    for (const Descriptor d : graph_.lists)
      if (leaves(d) && linked_.walk_of_chain[chain_of(d)] == none) collect(chain_of(d));
    for (std::uint32_t c = 0; c < selection_.size(); ++c)
      if (selection_[c] != none && graph_.chains[c].is_loop()) collect(c);
    return std::move(linked_);
  }

 private:
  bool leaves(Descriptor d) const { return selection_[chain_of(d)] == d; }
  bool arrives(Descriptor d) const { return selection_[chain_of(d)] == opposite(d); }

  /// Jump, for all nodes at once: around a node selected chains arrive and leave in turn, and a walk that
  /// arrives leaves by the selected descriptor before it.
  void find_successors() {
    constexpr std::size_t nodes_a_task = 8192;
    for_ranges(graph_.node_count(), nodes_a_task, [&](std::size_t begin, std::size_t end) {
      for (auto node = static_cast<std::uint32_t>(begin); node < end; ++node) {
        const auto list = graph_.list(node);
        Descriptor leaving = none;
        for (std::size_t i = list.size(); i-- > 0 && leaving == none;)
          if (leaves(list[i])) leaving = list[i];
        for (const Descriptor d : list) {
          if (leaves(d)) leaving = d;
          if (arrives(d)) next_[chain_of(d)] = leaving;
        }
      }
    });
  }

  /// Collect: one walk from a first chain until it closes.
  void collect(std::uint32_t first_chain) {
    const std::uint32_t walk = linked_.walk_count++;
    path_.clear();
    for (std::uint32_t c = first_chain; linked_.walk_of_chain[c] == none;) {
      linked_.walk_of_chain[c] = walk;
      const Descriptor d = selection_[c];
      if (convention_ == ContourConvention::ogc && !graph_.chains[c].is_loop()) part_at(graph_.start_node(d), walk);
      path_.push_back(d);
      if (graph_.chains[c].is_loop()) break;
      c = chain_of(next_[c]);
    }
    if (convention_ == ContourConvention::ogc) {
      for (const Descriptor d : path_)
        if (!graph_.chains[chain_of(d)].is_loop()) place_on_path_[graph_.start_node(d)] = none;
    }
    emit(0, walk);
  }

  /// The walk is at `node`: when it has been here before, what lies between is a contour of its own.
  void part_at(std::uint32_t node, std::uint32_t walk) {
    const std::uint32_t place = place_on_path_[node];
    if (place != none) {
      for (std::size_t i = place; i < path_.size(); ++i) place_on_path_[graph_.start_node(path_[i])] = none;
      emit(place, walk);
    }
    place_on_path_[node] = static_cast<std::uint32_t>(path_.size());
  }

  void emit(std::size_t begin, std::uint32_t walk) {
    linked_.descriptors.insert(linked_.descriptors.end(), path_.begin() + static_cast<std::ptrdiff_t>(begin),
                               path_.end());
    linked_.ends.push_back(static_cast<std::uint32_t>(linked_.descriptors.size()));
    linked_.walk.push_back(walk);
    path_.resize(begin);
  }

  const ChainGraph& graph_;
  const Selection& selection_;
  ContourConvention convention_;
  std::vector<Descriptor> next_;  ///< by chain: the descriptor its walk goes on with
  std::vector<Descriptor> path_;
  std::vector<std::uint32_t> place_on_path_;  ///< by node: index in path_ of the descriptor that starts there
  LinkedContours linked_;
};

}  // namespace

LinkedContours link(const ChainGraph& graph, const Selection& selection, ContourConvention convention) {
  return Linker(graph, selection, convention).run();
}

}  // namespace oblast
