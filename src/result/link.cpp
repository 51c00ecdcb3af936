#include "result/link.h"

#include <algorithm>

#include "base/fetch.h"
#include "base/index.h"
#include "base/large_pages.h"
#include "base/parallel.h"
#include "base/tuning.h"

namespace oblast::internal {
namespace {

/// The value for a chain whose walk leaves the range of nodes in which it began.
constexpr std::uint32_t far_walk = none - 1;

/// The data that the walks use.
struct Paths {
  const ChainGraph& graph;
  const Selection& selection;
  ContourConvention convention;
  LargeArray<Descriptor> next;              ///< by chain: the next descriptor of its walk
  LargeArray<std::uint32_t> walk_of_chain;  ///< by chain: none or far_walk until it is collected
  /// By node, for ogc: index in the path of the descriptor that starts there.
  LargeArray<std::uint32_t> place_on_path;

  bool leaves(Descriptor d) const { return selection[chain_of(d)] == d; }
  bool arrives(Descriptor d) const { return selection[chain_of(d)] == opposite(d); }
  bool is_collected(std::uint32_t chain) const { return walk_of_chain[chain] < far_walk; }
  bool is_loop(std::uint32_t chain) const { return graph.chains[chain].is_loop(); }
};

/// Collects walks into contours. Several collectors may work in parallel if their walks have no node in common.
class WalkCollector {
 public:
  explicit WalkCollector(Paths& paths) : paths_(paths) {}

  /// Collects the walks that stay among the nodes [begin, end). Marks the other walks, and stores their chains.
  void collect_near(std::uint32_t begin, std::uint32_t end) {
    const auto& list_ends = paths_.graph.list_ends;
    for (std::uint32_t i = begin == 0 ? 0 : list_ends[begin - 1]; i < list_ends[end - 1]; ++i) {
      if (i + fetched_ahead < list_ends[end - 1])
        fetch(&paths_.graph.chains[chain_of(paths_.graph.lists[i + fetched_ahead])]);
      const Descriptor d = paths_.graph.lists[i];
      if (!paths_.leaves(d)) continue;
      const std::uint32_t first = chain_of(d);
      if (paths_.walk_of_chain[first] == none) {
        collect(first, [&](std::uint32_t node, std::uint32_t chain) {
          return begin <= node && node < end && paths_.walk_of_chain[chain] != far_walk;
        });
      }
      if (!paths_.is_collected(first)) far_chains.push_back(first);
    }
  }

  /// Collects one walk, from its first chain until it closes.
  void collect(std::uint32_t first_chain) {
    collect(first_chain, [](std::uint32_t, std::uint32_t) { return true; });
  }

  Array<Descriptor> descriptors;
  Array<std::uint32_t> ends;  ///< by contour
  Array<std::uint32_t> walk;  ///< by contour
  std::uint32_t walk_count = 0;
  Array<std::uint32_t> far_chains;  ///< chains that begin in the range and belong to walks that leave it

 private:
  /// Collects one walk; or nothing, if it reaches a chain whose first node is not near.
  template <class IsNear>
  void collect(std::uint32_t first_chain, const IsNear& is_near) {
    const bool loop = paths_.is_loop(first_chain);
    const bool parts = paths_.convention == ContourConvention::ogc && !loop;
    const std::size_t contours = ends.size();
    path_.clear();
    std::uint32_t c = first_chain;
    do {
      steps_();
      const Descriptor d = paths_.selection[c];
      const std::uint32_t node = paths_.graph.start_node(d);
      if (!is_near(node, c)) return mark_far(contours, parts);
      paths_.walk_of_chain[c] = walk_count;
      if (parts) part_at(node);
      path_.push_back(d);
      if (!loop) c = chain_of(paths_.next[c]);
    } while (c != first_chain);
    if (parts) leave_path(0);
    emit(0);
    ++walk_count;
  }

  /// Undoes a walk. Its contours from `first_contour` on were already separated from it.
  void mark_far(std::size_t first_contour, bool parts) {
    if (parts) leave_path(0);
    emit(0);
    const std::size_t begin = first_contour == 0 ? 0 : ends[first_contour - 1];
    for (std::size_t i = begin; i < descriptors.size(); ++i) paths_.walk_of_chain[chain_of(descriptors[i])] = far_walk;
    descriptors.resize(begin);
    ends.resize(first_contour);
    walk.resize(first_contour);
  }

  void leave_path(std::size_t begin) {
    for (std::size_t i = begin; i < path_.size(); ++i) paths_.place_on_path[paths_.graph.start_node(path_[i])] = none;
  }

  /// The walk is at `node`. If it was here before, the chains since then are a separate contour.
  void part_at(std::uint32_t node) {
    const std::uint32_t place = paths_.place_on_path[node];
    if (place != none) {
      leave_path(place);
      emit(place);
    }
    paths_.place_on_path[node] = static_cast<std::uint32_t>(path_.size());
  }

  void emit(std::size_t begin) {
    descriptors.insert(descriptors.end(), path_.begin() + static_cast<std::ptrdiff_t>(begin), path_.end());
    ends.push_back(static_cast<std::uint32_t>(descriptors.size()));
    walk.push_back(walk_count);
    path_.resize(begin);
  }

  Paths& paths_;
  Array<Descriptor> path_;
  Steps steps_;
};

class Linker {
 public:
  Linker(const ChainGraph& graph, const Selection& selection, ContourConvention convention)
      : paths_{graph, selection, convention, {}, {}, {}} {
    fill_in_large_pages(paths_.next, graph.chains.size(), none);
    fill_in_large_pages(paths_.walk_of_chain, graph.chains.size(), none);
    if (convention == ContourConvention::ogc) fill_in_large_pages(paths_.place_on_path, graph.node_count(), none);
  }

  LinkedContours run() {
    find_successors();
    // Nodes that are close in the plane are close in memory, so most short walks stay within a range.
    constexpr std::size_t nodes_a_range = tuning::linked_nodes_a_range;
    const std::size_t node_count = paths_.graph.node_count(), in_ranges = node_count <= nodes_a_range ? 0 : node_count;
    Array<WalkCollector> collectors(range_count(in_ranges, nodes_a_range) + 1, WalkCollector(paths_));
    for_numbered_ranges(in_ranges, nodes_a_range, [&](std::size_t i, std::size_t begin, std::size_t end) {
      collectors[i].collect_near(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end));
    });
    WalkCollector& others = collectors.back();
    if (in_ranges == 0) {
      for (const Descriptor d : paths_.graph.lists)
        if (paths_.leaves(d) && !paths_.is_collected(chain_of(d))) others.collect(chain_of(d));
    }
    for (const WalkCollector& part : std::span(collectors).first(collectors.size() - 1))
      for (const std::uint32_t c : part.far_chains)
        if (!paths_.is_collected(c)) others.collect(c);
    const auto chain_count = static_cast<std::uint32_t>(paths_.selection.size());
    for (std::uint32_t c = paths_.graph.first_loop; c < chain_count; ++c)
      if (paths_.selection[c] != none) others.collect(c);
    return join(std::move(collectors));
  }

 private:
  /// Jump, for all nodes at once. Around a node, selected chains arrive and leave alternately. A walk that arrives
  /// leaves by the selected descriptor before it.
  void find_successors() {
    for_ranges(paths_.graph.node_count(), tuning::linked_nodes_a_task, [&](std::size_t begin, std::size_t end) {
      for (auto node = static_cast<std::uint32_t>(begin); node < end; ++node) {
        const auto list = paths_.graph.list(node);
        Descriptor leaving = none;
        for (std::size_t i = list.size(); i-- > 0 && leaving == none;)
          if (paths_.leaves(list[i])) leaving = list[i];
        for (const Descriptor d : list) {
          if (paths_.leaves(d)) leaving = d;
          if (paths_.arrives(d)) paths_.next[chain_of(d)] = leaving;
        }
      }
    });
  }

  LinkedContours join(Array<WalkCollector> collectors) {
    LinkedContours linked;
    if (collectors.size() == 1) {
      WalkCollector& only = collectors[0];
      return {std::move(only.descriptors), std::move(only.ends), std::move(only.walk), std::move(paths_.walk_of_chain),
              only.walk_count};
    }
    Array<std::uint32_t> first_descriptor, first_contour, first_walk;
    std::uint32_t descriptors = 0, contours = 0;
    for (const WalkCollector& part : collectors) {
      first_descriptor.push_back(descriptors);
      first_contour.push_back(contours);
      first_walk.push_back(linked.walk_count);
      descriptors += static_cast<std::uint32_t>(part.descriptors.size());
      contours += static_cast<std::uint32_t>(part.ends.size());
      linked.walk_count += part.walk_count;
    }
    resize_with_zeros(linked.descriptors, descriptors);
    resize_with_zeros(linked.ends, contours);
    resize_with_zeros(linked.walk, contours);
    for_ranges(collectors.size(), 1, [&](std::size_t i, std::size_t past) {
      for (; i < past; ++i) {
        const WalkCollector& part = collectors[i];
        std::copy(part.descriptors.begin(), part.descriptors.end(), linked.descriptors.begin() + first_descriptor[i]);
        for (const Descriptor d : part.descriptors) paths_.walk_of_chain[chain_of(d)] += first_walk[i];
        for (std::size_t c = 0; c < part.ends.size(); ++c) {
          linked.ends[first_contour[i] + c] = part.ends[c] + first_descriptor[i];
          linked.walk[first_contour[i] + c] = part.walk[c] + first_walk[i];
        }
      }
    });
    linked.walk_of_chain = std::move(paths_.walk_of_chain);
    return linked;
  }

  Paths paths_;
};

}  // namespace

LinkedContours link(const ChainGraph& graph, const Selection& selection, ContourConvention convention) {
  return Linker(graph, selection, convention).run();
}

}  // namespace oblast::internal
