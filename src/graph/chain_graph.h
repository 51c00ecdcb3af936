// The graph of an arrangement: nodes, where something happens, and chains, all that lies between two.
//
//   strand     n1 --- p --- p --- n2 --- p --- n3       n: node,  p: passes through, meets nothing
//   chains     [    first chain    ][  second   ]       ranges of the strands' points
//
// A chain keeps the label of its first edge (Leonov and Nikitin, rule 2.1), so the graph has as many
// elements as there are meetings. A contour that meets nothing is one closed chain without nodes. A node
// holds its connectivity list L(x): descriptors of the chains that end there, counter-clockwise.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/fetch.h"
#include "base/index.h"
#include "base/large_pages.h"
#include "noding/strands.h"

namespace oblast::internal {

using noding::Winding;

/// How many elements ahead of a walk through chains or stops what they point to is fetched.
inline constexpr std::uint32_t fetched_ahead = 16;

struct Chain {
  std::uint32_t first;        ///< index of its first vertex in the points
  std::uint32_t last;         ///< index of its last vertex, > first
  std::uint32_t from;         ///< node of the first vertex; none for a closed chain without nodes
  std::uint32_t to;           ///< node of the last vertex
  std::uint32_t before;       ///< the chain that ends in its first vertex, along the strand; none where it begins
  std::uint32_t merged_into;  ///< the chain that stands for this one: itself, unless an identical edge does
  Winding change;             ///< left minus right, of all merged chains together

  bool is_loop() const { return from == none; }
};

/// A descriptor: a chain as seen from one of its ends, leaving it. Twice the chain's index, plus one
/// when the chain is left backward (the descriptor sits at its last vertex).
using Descriptor = std::uint32_t;
constexpr std::uint32_t chain_of(Descriptor d) { return d >> 1; }
constexpr bool is_backward(Descriptor d) { return d & 1; }
constexpr Descriptor forward(std::uint32_t chain) { return chain << 1; }
constexpr Descriptor opposite(Descriptor d) { return d ^ 1; }

struct ChainGraph {
  noding::Strands strands;
  LargeArray<Chain> chains;               ///< by the nodes they leave forward; those without nodes come last
  std::uint32_t first_loop = 0;           ///< the first of those
  LargeArray<std::uint32_t> node_vertex;  ///< by node: one vertex that lies there
  LargeArray<std::uint32_t> list_ends;    ///< by node: past its last descriptor in `lists`
  LargeArray<Descriptor> lists;           ///< connectivity lists, each counter-clockwise (see angular_order.h)

  /// For who goes through the chains in order: their points are all over the strands.
  void fetch_points_ahead(std::uint32_t chain) const {
    if (chain + fetched_ahead < chains.size()) fetch(&strands.points[chains[chain + fetched_ahead].first]);
  }

  std::size_t node_count() const { return node_vertex.size(); }
  std::span<const Descriptor> list(std::uint32_t node) const {
    const std::uint32_t begin = node == 0 ? 0 : list_ends[node - 1];
    return std::span(lists).subspan(begin, list_ends[node] - begin);
  }
  const Point& point(std::uint32_t vertex) const { return strands.points[vertex]; }

  /// A chain is in the arrangement when it stands for itself and changes some winding number.
  bool is_live(std::uint32_t chain) const {
    return chains[chain].merged_into == chain && !chains[chain].change.is_zero();
  }
  std::uint32_t start_node(Descriptor d) const {
    return is_backward(d) ? chains[chain_of(d)].to : chains[chain_of(d)].from;
  }
  std::uint32_t end_node(Descriptor d) const { return start_node(opposite(d)); }
  std::uint32_t start_vertex(Descriptor d) const {
    return is_backward(d) ? chains[chain_of(d)].last : chains[chain_of(d)].first;
  }
  /// The vertex after the start vertex: it gives the descriptor's direction.
  std::uint32_t next_vertex(Descriptor d) const {
    return is_backward(d) ? chains[chain_of(d)].last - 1 : chains[chain_of(d)].first + 1;
  }
  /// Winding change when the descriptor's chain, in the descriptor's direction, is crossed from right to left.
  Winding change(Descriptor d) const {
    // Without a branch: which way a chain runs is hard to foresee.
    const Winding w = chains[chain_of(d)].change;
    const std::int32_t sign = 1 - 2 * static_cast<std::int32_t>(is_backward(d));
    return {sign * w.a, sign * w.b};
  }
};

/// REQUIRES: a strand with a node begins and ends with one. Cost: O(n) to pass over the vertices, O(k log d) for k
/// chain ends at nodes of degree d.
ChainGraph build_chain_graph(noding::Strands strands);

}  // namespace oblast::internal
