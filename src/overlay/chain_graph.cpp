#include "overlay/chain_graph.h"

#include <algorithm>
#include <bit>

#include "noding/point_hash.h"
#include "overlay/angular_order.h"

namespace oblast {
namespace {

using noding::Strands;

/// Open addressing over 32-bit ids; `Equal` compares an id stored before with the one looked for.
class IdTable {
 public:
  explicit IdTable(std::size_t most) : slots_(std::bit_ceil(most * 2 + 2), none), mask_(slots_.size() - 1) {}

  template <class Equal>
  std::uint32_t find_or_insert(std::uint64_t hash, std::uint32_t id, const Equal& equal) {
    for (;; ++hash) {
      std::uint32_t& slot = slots_[hash & mask_];
      if (slot == none) return slot = id;
      if (equal(slot)) return slot;
    }
  }

 private:
  std::vector<std::uint32_t> slots_;
  std::uint64_t mask_;
};

/// Gives each place where a flagged vertex lies one node.
class NodeNumbering {
 public:
  NodeNumbering(const Strands& strands, std::size_t flagged, std::vector<std::uint32_t>& node_vertex)
      : points_(strands.points), node_vertex_(node_vertex), table_(flagged) {}

  std::uint32_t node_at(std::uint32_t vertex) {
    const std::uint32_t fresh = static_cast<std::uint32_t>(node_vertex_.size());
    const std::uint32_t node = table_.find_or_insert(noding::hash(points_[vertex]), fresh, [&](std::uint32_t old) {
      return points_[node_vertex_[old]] == points_[vertex];
    });
    if (node == fresh) node_vertex_.push_back(vertex);
    return node;
  }

 private:
  const std::vector<Point>& points_;
  std::vector<std::uint32_t>& node_vertex_;
  IdTable table_;
};

/// Step 1: strands to chains.
void cut_into_chains(ChainGraph& graph) {
  const Strands& strands = graph.strands;
  const auto is_node = [&](std::uint32_t v) { return (strands.flags[v] & noding::node_flag) != 0; };
  const auto flagged = static_cast<std::size_t>(std::count_if(
      strands.flags.begin(), strands.flags.end(), [](std::uint8_t f) { return (f & noding::node_flag) != 0; }));
  graph.chains.reserve(flagged + strands.size());
  NodeNumbering nodes(strands, flagged, graph.node_vertex);
  const auto add = [&](std::uint32_t first, std::uint32_t last, std::uint32_t from, std::uint32_t to, Winding change) {
    graph.chains.push_back({first, last, from, to, static_cast<std::uint32_t>(graph.chains.size()), change});
  };
  for (std::size_t s = 0; s < strands.size(); ++s) {
    const std::uint32_t begin = strands.begin(s), last = strands.ends[s] - 1;
    if (!is_node(begin)) {
      add(begin, last, none, none, strands.change[s]);
      continue;
    }
    std::uint32_t first = begin, from = nodes.node_at(begin);
    for (std::uint32_t v = begin + 1; v <= last; ++v) {
      if (!is_node(v)) continue;
      const std::uint32_t to = nodes.node_at(v);
      add(first, v, from, to, strands.change[s]);
      first = v;
      from = to;
    }
  }
}

/// Step 2: chains of one edge with the same ends become one, with the sum of the changes. Longer chains
/// cannot coincide: every vertex of theirs would be a node.
void merge_coincident_chains(ChainGraph& graph) {
  auto& chains = graph.chains;
  IdTable table(chains.size());
  for (std::uint32_t c = 0; c < chains.size(); ++c) {
    Chain& chain = chains[c];
    if (chain.is_loop() || chain.last - chain.first > 1) continue;
    const std::uint64_t low = std::min(chain.from, chain.to), high = std::max(chain.from, chain.to);
    const std::uint32_t same = table.find_or_insert(noding::mix(low << 32 | high), c, [&](std::uint32_t old) {
      return std::min(chains[old].from, chains[old].to) == low && std::max(chains[old].from, chains[old].to) == high;
    });
    if (same == c) continue;
    chain.merged_into = same;
    const bool same_direction = chains[same].from == chain.from;
    const Winding change = same_direction ? chain.change : -chain.change;
    chains[same].change = graph.strands.parity.reduce(chains[same].change + change);
  }
}

/// A descriptor with the point it aims at, so that sorting by angle finds it at hand.
struct Aimed {
  Point at;
  Descriptor descriptor;
};

/// Step 3: the connectivity lists L(x) of live chains, each sorted by angle.
void build_connectivity_lists(ChainGraph& graph) {
  auto& ends = graph.list_ends;
  ends.assign(graph.node_count() + 1, 0);
  const auto chain_count = static_cast<std::uint32_t>(graph.chains.size());
  const auto for_each_live = [&](const auto& visit) {
    for (std::uint32_t c = 0; c < chain_count; ++c)
      if (!graph.chains[c].is_loop() && graph.is_live(c)) visit(c, graph.chains[c]);
  };
  for_each_live([&](std::uint32_t, const Chain& chain) {
    ++ends[chain.from + 1];
    ++ends[chain.to + 1];
  });
  for (std::size_t i = 1; i < ends.size(); ++i) ends[i] += ends[i - 1];
  std::vector<Aimed> lists(ends.back());
  // ends[node] moves from the beginning of the node's list to its end as the list fills.
  for_each_live([&](std::uint32_t c, const Chain& chain) {
    lists[ends[chain.from]++] = {graph.point(chain.first + 1), forward(c)};
    lists[ends[chain.to]++] = {graph.point(chain.last - 1), opposite(forward(c))};
  });
  ends.pop_back();

  for (std::uint32_t node = 0; node < graph.node_count(); ++node) {
    const std::uint32_t begin = node == 0 ? 0 : ends[node - 1];
    const Point& x = graph.point(graph.node_vertex[node]);
    std::sort(lists.begin() + begin, lists.begin() + ends[node],
              [&](const Aimed& p, const Aimed& q) { return angularly_less(x, p.at, q.at); });
  }
  graph.lists.reserve(lists.size());
  for (const Aimed& aimed : lists) graph.lists.push_back(aimed.descriptor);
}

}  // namespace

ChainGraph build_chain_graph(Strands strands) {
  ChainGraph graph;
  graph.strands = std::move(strands);
  cut_into_chains(graph);
  merge_coincident_chains(graph);
  build_connectivity_lists(graph);
  return graph;
}

}  // namespace oblast
