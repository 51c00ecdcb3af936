// Stage 3 for rows: which sources cover each face of the arrangement.
//
//        \   f   /       A face cycle is a walk along descriptors with the same face on the left: at each node it
//        leaves
//     d   \     /        by the next descriptor clockwise. Every descriptor is in one cycle. Across a chain the sources
//    ----->x---'         change by the chain's change. So within a component one cycle gives all, and the cycle around
//           \   f        the component has the sources of the face that the component lies in (graph/components.h).
#pragma once

#include <cstdint>

#include "base/large_pages.h"
#include "graph/chain_graph.h"
#include "noding/source_sets.h"

namespace oblast::internal {

/// The sources of a face, of either operand.
struct FaceLabel {
  SourceSets::Set a = SourceSets::empty;
  SourceSets::Set b = SourceSets::empty;

  friend bool operator==(const FaceLabel&, const FaceLabel&) = default;
};

/// The sets that labels stand for.
struct LabelSets {
  SourceSets a, b;
};

struct FaceLabels {
  LargeArray<std::uint32_t> cycle;  ///< by descriptor; anything where a chain is not live
  Array<FaceLabel> of_cycle;        ///< members only, each counting once

  FaceLabel left_of(Descriptor d) const { return of_cycle[cycle[d]]; }
  FaceLabel right_of(Descriptor d) const { return of_cycle[cycle[opposite(d)]]; }
};

/// REQUIRES: the changes of the graph are handles (graph.strands.rules.sources). Cost: linear in the chains, plus O(32)
/// for each source that changes from a face to the next one, plus what the sets' members cost.
FaceLabels label_faces(const ChainGraph& graph, LabelSets& sets);

}  // namespace oblast::internal
