#include "engines/leonov_nikitin/relative_labels.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "base/fetch.h"
#include "base/large_pages.h"
#include "base/parallel.h"
#include "base/tuning.h"

namespace oblast::internal::leonov_nikitin {
namespace {

constexpr std::uint32_t range_size = tuning::labelled_nodes_a_range;

/// A chain that ends in one range and begins in another, with its right side relative to the piece at its end.
struct Border {
  std::uint32_t chain;
  std::uint32_t piece;  ///< the piece of the node where the chain ends
  Winding right;
};

/// Carries labels through the nodes of one range.
class RangeLabelling {
 public:
  RangeLabelling(const ChainGraph& graph, std::uint32_t begin, std::uint32_t end, RelativeLabels& labels)
      : graph_(graph), begin_(begin), end_(end), labels_(labels), pending_(end - begin + 1) {}

  void run() {
    for (std::uint32_t node = begin_; node < end_; ++node) {
      if (labels_.component[node] != none || graph_.list(node).empty()) continue;
      labels_.component[node] = pieces;
      label_around(node, graph_.list(node)[0], {});
      // First in, first out: the next nodes are known early enough to be prefetched.
      for (std::size_t i = 0; i < pending_count_; ++i) {
        fetch_ahead(i);
        const Descriptor known = pending_[i];
        const Winding right = labels_.right[chain_of(known)];
        label_around(graph_.start_node(known), known,
                     is_backward(known) ? right + graph_.change(opposite(known)) : right);
      }
      pending_count_ = 0;
      ++pieces;
    }
  }

  std::uint32_t pieces = 0;
  Array<Border> borders;  ///< their pieces are counted from the first one of this range

 private:
  bool is_here(std::uint32_t node) const { return begin_ <= node && node < end_; }

  void fetch_ahead(std::size_t i) const {
    constexpr std::size_t chain_ahead = 16, node_ahead = 12, list_ahead = 8, others_ahead = 4;
    if (i + chain_ahead < pending_count_) fetch(&graph_.chains[chain_of(pending_[i + chain_ahead])]);
    if (i + node_ahead < pending_count_) fetch(&graph_.list_ends[graph_.start_node(pending_[i + node_ahead])]);
    if (i + list_ahead < pending_count_) fetch(graph_.list(graph_.start_node(pending_[i + list_ahead])).data());
    if (i + others_ahead < pending_count_)
      for (const Descriptor d : graph_.list(graph_.start_node(pending_[i + others_ahead])))
        fetch(&graph_.chains[chain_of(d)]);
  }

  /// Rule 2.2: goes around a node, starting at a descriptor with known winding numbers on its right (as it leaves the
  /// node). Rule 2.1: continues to nodes not seen yet. The label of a chain is written at its beginning. The processor
  /// cannot predict which way chains run and which nodes were seen. So there are no branches for these.
  void label_around(std::uint32_t node, Descriptor known, Winding right_of_known) {
    const auto list = graph_.list(node);
    const std::uint32_t piece = labels_.component[node];
    // The sector right of the first descriptor, because the changes around the node sum to zero.
    Winding sector, first_sector;
    for (const Descriptor d : list) {
      first_sector = d == known ? right_of_known - sector : first_sector;
      sector = sector + graph_.change(d);
    }
    sector = first_sector;
    for (const Descriptor d : list) {
      const Chain& chain = graph_.chains[chain_of(d)];
      const Winding left = sector + graph_.change(d);
      const Winding right = is_backward(d) ? left : sector;
      const std::uint32_t other = is_backward(d) ? chain.from : chain.to;
      sector = left;
      if (!is_here(other)) {
        if (is_backward(d))
          borders.push_back({chain_of(d), piece, right});
        else
          labels_.right[chain_of(d)] = right;
        continue;
      }
      labels_.right[chain_of(d)] = right;
      const bool is_new = labels_.component[other] == none;
      labels_.component[other] = is_new ? piece : labels_.component[other];
      pending_[pending_count_] = opposite(d);
      pending_count_ += is_new;
    }
  }

  const ChainGraph& graph_;
  std::uint32_t begin_, end_;
  RelativeLabels& labels_;
  LargeArray<Descriptor> pending_;  ///< has each node at most once, and one more element, which is not counted
  std::size_t pending_count_ = 0;
};

/// Disjoint sets of pieces. For each piece it stores the difference between the labels of its root and its own.
class PieceSets {
 public:
  explicit PieceSets(std::uint32_t size) : parent_(size), offset_(size) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  std::pair<std::uint32_t, Winding> find(std::uint32_t piece) {
    Winding offset;
    while (parent_[piece] != piece) {
      const std::uint32_t parent = parent_[piece];
      if (parent_[parent] != parent) {
        offset_[piece] = offset_[piece] + offset_[parent];
        parent_[piece] = parent_[parent];
      }
      offset = offset + offset_[piece];
      piece = parent_[piece];
    }
    return {piece, offset};
  }

  /// Unites two sets. The labels of q plus `difference` are labels of p.
  void unite(std::uint32_t p, std::uint32_t q, Winding difference) {
    const auto [p_root, p_offset] = find(p);
    const auto [q_root, q_offset] = find(q);
    const Winding between = p_offset + difference - q_offset;
    if (p_root < q_root) {
      parent_[q_root] = p_root;
      offset_[q_root] = between;
    } else if (q_root < p_root) {
      parent_[p_root] = q_root;
      offset_[p_root] = -between;
    }
  }

 private:
  Array<std::uint32_t> parent_;
  Array<Winding> offset_;
};

/// Joins pieces to components. `first_piece`: by range.
void join_pieces(const ChainGraph& graph, const Array<Array<Border>>& borders, const Array<std::uint32_t>& first_piece,
                 std::uint32_t piece_count, RelativeLabels& labels) {
  const auto piece_of = [&](std::uint32_t node) { return labels.component[node] + first_piece[node / range_size]; };
  PieceSets sets(piece_count);
  Steps steps;
  for (std::size_t range = 0; range < borders.size(); ++range)
    for (const Border& b : borders[range]) {
      steps();
      sets.unite(piece_of(graph.chains[b.chain].from), b.piece + first_piece[range], labels.right[b.chain] - b.right);
    }

  struct Place {
    std::uint32_t component;
    Winding offset;
  };
  Array<Place> places(piece_count);
  for (std::uint32_t piece = 0; piece < piece_count; ++piece) {
    const auto [root, offset] = sets.find(piece);
    // The root is the smallest element of its set, so its place is known before those of the others.
    places[piece] = {root == piece ? labels.component_count++ : places[root].component, offset};
  }
  for_ranges(graph.chains.size(), tuning::labelled_elements_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      const Chain& chain = graph.chains[c];
      if (chain.is_loop() || labels.component[chain.from] == none) continue;
      labels.right[c] = labels.right[c] + places[piece_of(chain.from)].offset;
    }
  });
  for_ranges(graph.node_count(), tuning::labelled_elements_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node)
      if (labels.component[node] != none)
        labels.component[node] = places[piece_of(static_cast<std::uint32_t>(node))].component;
  });
}

}  // namespace

RelativeLabels label_relatively(const ChainGraph& graph) {
  RelativeLabels labels;
  fill_in_large_pages(labels.right, graph.chains.size(), Winding{});
  fill_in_large_pages(labels.component, graph.node_count(), none);
  const auto node_count = static_cast<std::uint32_t>(graph.node_count());
  if (node_count <= range_size) {
    RangeLabelling all(graph, 0, node_count, labels);
    all.run();
    labels.component_count = all.pieces;
    return labels;
  }
  const std::size_t ranges = range_count(node_count, range_size);
  Array<Array<Border>> borders(ranges);
  Array<std::uint32_t> pieces(ranges), first_piece(ranges);
  for_numbered_ranges(node_count, range_size, [&](std::size_t r, std::size_t begin, std::size_t end) {
    RangeLabelling range(graph, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), labels);
    range.run();
    pieces[r] = range.pieces;
    borders[r] = std::move(range.borders);
  });
  std::exclusive_scan(pieces.begin(), pieces.end(), first_piece.begin(), 0U);
  join_pieces(graph, borders, first_piece, first_piece.back() + pieces.back(), labels);
  return labels;
}

}  // namespace oblast::internal::leonov_nikitin
