// What is connected in the graph, and what lies around it.
//
//     +-------------+      Two components. The smallest vertex p of the inner one lies in a face of the outer one: the
//     |    p---+    |      face above the chain that is directly below p. So each component needs one point-in-region
//     |    |   |    |      query. That chain belongs to a component with a smaller smallest vertex, so in the order of
//     |    +---+    |      smallest vertices the answer is known already.
//     +----|--------+
//          v               A component whose smallest vertex is in the box of no other has nothing around it and asks
//                          nothing; one whose box holds no such vertex is around nothing and answers nothing.
#pragma once

#include <cstdint>
#include <span>

#include "base/call_memory.h"
#include "graph/chain_graph.h"
#include "graph/locate_below.h"
#include "plane/box.h"

namespace oblast::internal {

struct Component {
  std::uint32_t chain = none;   ///< a chain that its smallest vertex is on
  std::uint32_t vertex = none;  ///< that vertex
};

/// Components of live chains. A contour that meets nothing is one by itself.
struct Components {
  LargeArray<std::uint32_t> of_chain;  ///< none where a chain is not live
  Array<Component> all;
  Array<Box> boxes;  ///< by component

  std::size_t size() const { return all.size(); }
};

/// REQUIRES: component_of_node numbers what is connected, from 0 to count - 1; anything where no live chain ends.
/// Cost: linear in the vertices.
Components find_components(const ChainGraph& graph, std::span<const std::uint32_t> component_of_node,
                           std::uint32_t count);

/// The smallest vertex of a component, seen from outside.
struct Outside {
  BelowQuery query;  ///< that vertex and the lower of the edges there
  Descriptor side;   ///< a descriptor with the outside on its left
};

Outside outside_of(const ChainGraph& graph, const Component& component);

/// What lies below the components that may have something around them.
struct Surroundings {
  Array<std::uint32_t> asking;  ///< those components, in the order of their smallest vertices
  Array<Below> below;           ///< by their place in `asking`
};

/// `outside` is by component. Cost: as locate_below.
Surroundings find_surroundings(const ChainGraph& graph, const Components& components, std::span<const Outside> outside);

}  // namespace oblast::internal
