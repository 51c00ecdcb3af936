#include "check/faces.h"

#include <algorithm>
#include <numeric>

#include "base/disjoint_sets.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "check/strands_of.h"
#include "engines/leonov_nikitin/label.h"
#include "graph/locate_below.h"

namespace oblast::internal::checking {
namespace {

class Faces {
 public:
  Faces(const RegionView& regions, const ChainGraph& graph)
      : regions_(regions),
        graph_(graph),
        by_first_(graph.chains.size()),
        polygon_(graph.chains.size()),
        faces_(graph.chains.size()) {
    std::iota(by_first_.begin(), by_first_.end(), 0U);
    parallel_sort(by_first_.begin(), by_first_.end(),
                  [&](std::uint32_t c, std::uint32_t d) { return graph_.chains[c].first < graph_.chains[d].first; });
    for (std::uint32_t p = 0, i = 0; p < regions_.polygon_count(); ++p) {
      const std::uint32_t end = graph_.strands.ends[regions_.polygon_end(p) - 1];
      for (; i < by_first_.size() && graph_.chains[by_first_[i]].first < end; ++i) polygon_[by_first_[i]] = p;
    }
  }

  std::optional<Finding> run(const Array<Role>& roles) {
    FirstFinding first;
    join_at_nodes(first);
    join_below_holes(roles, first);
    return first.get() ? first.get() : find_parted();
  }

 private:
  /// The chain of an edge, by its index in the strands.
  std::uint32_t chain_at(std::uint32_t index) const {
    const auto after = std::upper_bound(by_first_.begin(), by_first_.end(), index,
                                        [&](std::uint32_t i, std::uint32_t c) { return i < graph_.chains[c].first; });
    return *std::prev(after);
  }

  std::uint32_t vertex_of_chain(std::uint32_t chain) const {
    return vertex_of(graph_.strands, graph_.chains[chain].first);
  }

  /// Both bound one face.
  void join(std::uint32_t chain, std::uint32_t other, const Point& at, FirstFinding& first) {
    faces_.unite(chain, other);
    if (polygon_[chain] == polygon_[other]) return;
    const std::uint32_t v = vertex_of_chain(chain), w = vertex_of_chain(other);
    first.offer({FaultKind::other_polygon, std::min(v, w), std::max(v, w), at});
  }

  void join_at_nodes(FirstFinding& first) {
    Steps steps(graph_.node_count());
    for (std::uint32_t node = 0; node < graph_.node_count(); ++node) {
      steps();
      const std::span<const Descriptor> list = graph_.list(node);
      for (std::size_t i = 0; i < list.size(); ++i) {
        const Descriptor after = list[i + 1 < list.size() ? i + 1 : 0];
        if (!is_backward(list[i]))
          join(chain_of(list[i]), chain_of(after), graph_.point(graph_.node_vertex[node]), first);
      }
    }
  }

  /// What lies directly below a hole's smallest vertex bounds the face that the hole is in.
  void join_below_holes(const Array<Role>& roles, FirstFinding& first) {
    Array<std::uint32_t> holes;
    Array<BelowQuery> queries;
    for (std::uint32_t c = 0; c < roles.size(); ++c) {
      if (!roles[c].is_hole) continue;
      holes.push_back(c);
      queries.push_back(roles[c].arrival);
    }
    const Array<Below> below = locate_below(graph_, by_first_, queries);
    for (std::size_t i = 0; i < holes.size(); ++i)
      join(chain_at(roles[holes[i]].edge + holes[i]), below[i].chain, queries[i].p, first);
  }

  std::optional<Finding> find_parted() {
    FirstFinding first;
    Steps steps(by_first_.size());
    for (const std::uint32_t chain : by_first_) {
      steps();
      const std::uint32_t contour = regions_.polygon_begin(polygon_[chain]);
      if (faces_.find(chain) == faces_.find(chain_at(graph_.strands.begin(contour)))) continue;
      const std::uint32_t v = vertex_of_chain(chain);
      first.offer({FaultKind::not_connected, v, regions_.contour_begin(contour), regions_.points[v]});
      break;
    }
    return first.get();
  }

  const RegionView& regions_;
  const ChainGraph& graph_;
  Array<std::uint32_t> by_first_;  ///< chains along the strands
  Array<std::uint32_t> polygon_;   ///< by chain
  DisjointSets faces_;             ///< of chains: those of one set bound one face
};

}  // namespace

std::optional<Finding> find_wrong_side(const ChainGraph& graph) {
  const LargeArray<Winding> right = leonov_nikitin::label(graph);
  FirstFinding first;
  for_ranges(graph.chains.size(), tuning::labelled_elements_a_task, [&](std::size_t c, std::size_t end) {
    for (; c < end; ++c) {
      const std::uint32_t index = graph.chains[c].first;
      if (right[c].a != 0)
        first.offer({FaultKind::wrong_side, vertex_of(graph.strands, index), none, graph.point(index)});
    }
  });
  return first.get();
}

std::optional<Finding> find_bad_face(const RegionView& regions, const ChainGraph& graph, const Array<Role>& roles) {
  return Faces(regions, graph).run(roles);
}

}  // namespace oblast::internal::checking
