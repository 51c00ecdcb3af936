// Stops: the vertices at which strands are cut into chains.
//
// Where a strand has a node it stops: its first vertex, its last, and every one flagged in between.
//
//   strand     s0 ------- s1 ------- s2          stops, numbered through all strands
//              [ chain 7  ][ chain 3 ]           a chain runs from a stop to the next one of its strand
//
// Stops at one place are one node. They are brought together by sorting along a curve:
//
//   order      s2 s9 | s0 | s1 s4 s7 | s3 ...    stops, node by node; | where a node begins
//
// So nodes that are near in the plane are near in memory, and so are the chains, which are numbered by the nodes they
// leave. This is what makes every later walk over the graph quick.
#pragma once

#include <cstdint>

#include "base/call_memory.h"
#include "base/fetch.h"
#include "base/large_pages.h"
#include "graph/chain_graph.h"
#include "noding/strands.h"
#include "plane/curve_order.h"

namespace oblast::internal {

struct Stop {
  std::uint32_t vertex;
  std::uint32_t strand;
  std::uint32_t node;
  std::uint32_t chain;  ///< that starts here, if one does
};

struct Stops {
  LargeArray<Stop> along;                ///< along the strands
  LargeArray<std::uint32_t> loops;       ///< strands that do not stop: contours without nodes
  LargeArray<Keyed> order;               ///< stops, node by node
  LargeArray<std::uint8_t> begins_node;  ///< by place in `order`: 1 where a node begins, else 0
  LargeArray<std::uint32_t> ends;        ///< by node: past its last stop in `order`

  bool has_chain_before(std::uint32_t stop) const { return stop > 0 && has_chain_after(stop - 1); }
  bool has_chain_after(std::uint32_t stop) const {
    return stop + 1 < along.size() && along[stop].strand == along[stop + 1].strand;
  }
  std::uint32_t degree(std::uint32_t stop) const { return has_chain_before(stop) + has_chain_after(stop); }

  /// Stops are looked at node by node, so they come from all over the strands. Those from `past` on may be in work on
  /// another thread.
  void fetch_ahead(std::size_t i, std::size_t past) const {
    if (i + fetched_ahead < past) fetch_around(along, order[i + fetched_ahead].index);
  }
};

/// How many there are of what nodes bring along.
struct NodeCounts {
  std::uint32_t nodes = 0;
  std::uint32_t chains = 0;   ///< that leave the nodes forward
  std::uint32_t entries = 0;  ///< of connectivity lists

  void operator+=(const NodeCounts& o) {
    nodes += o.nodes;
    chains += o.chains;
    entries += o.entries;
  }
};

/// A range of stops in order that holds whole nodes. It ends where the next range begins.
struct NodeRange {
  std::size_t begin;
  NodeCounts before = {};  ///< in all ranges before it
};

/// Step 1: where strands stop. Fills `along`, without nodes and chains, and `loops`.
Stops find_stops(const noding::Strands& strands);

/// Step 2a: fills `order` and `begins_node`. The ranges side by side make all of the order; the last range is past all.
Array<NodeRange> order_stops(const noding::Strands& strands, Stops& stops);

}  // namespace oblast::internal
