// Sets of sources: which rows cover a face, and how often each.
//
// A set is a radix tree over the bits of the sources (Okasaki and Gill, "Fast Mergeable Integer Maps", 1998):
//
//            branch 1--          sources 4 and 5 (100 and 101 in binary) differ first in the lowest bit. A set that
//            /      \            differs from another one in a few sources shares all other branches with it.
//         0-- ...   10-
//                  /   \         Every tree is kept once. So equal sets are one index, crossing an edge costs the
//                 4     5        height of the tree for each source that changes, and a deep stack of rows takes
//                                little memory: of each new face, the path from the root to what is new.
#pragma once

#include <cstdint>

#include "base/call_memory.h"
#include "base/index.h"

namespace oblast::internal {

class SourceSets {
 public:
  using Set = std::uint32_t;
  static constexpr Set empty = 0;

  /// `least`: how often a source must count to be a member. REQUIRES: least >= 1.
  explicit SourceSets(std::int32_t least = 1);

  /// The set in which the source counts `by` more; one that counts 0 is not in it. Cost: O(32).
  Set changed(Set set, std::uint32_t source, std::int32_t by);

  /// The counts of p and q added; or those of q taken away. Counts may become negative. Cost: O(32) for each source of
  /// q.
  Set sum(Set p, Set q) { return combined(p, q, 1); }
  Set difference(Set p, Set q) { return combined(p, q, -1); }

  /// The members, each counting once. Cost: linear in the branches that were not asked about before.
  Set members(Set set);

  /// How many sources are in it.
  std::uint32_t size(Set set) const { return set == empty ? 0 : nodes_[set].size; }
  bool contains(Set set, std::uint32_t source) const;
  /// The first source of a set that is not empty. Cost: O(32).
  std::uint32_t lowest(Set set) const;

  /// Calls visit(source) for each source, in order.
  template <class Visit>
  void for_each(Set set, const Visit& visit) const {
    if (set == empty) return;
    const Node& node = nodes_[set];
    if (node.is_leaf()) return visit(node.prefix);
    for_each(node.left, visit);
    for_each(node.right, visit);
  }

  /// Calls visit(source, count) for each source, in order.
  template <class Visit>
  void for_each_count(Set set, const Visit& visit) const {
    if (set == empty) return;
    const Node& node = nodes_[set];
    if (node.is_leaf()) return visit(node.prefix, node.count());
    for_each_count(node.left, visit);
    for_each_count(node.right, visit);
  }

  /// Calls visit(source) for each source that is in p and not in q, in order. Where p and q share branches these cost
  /// nothing. REQUIRES: each source counts once.
  template <class Visit>
  void for_each_only_in(Set p, Set q, const Visit& visit) const {
    if (p == q || p == empty) return;
    if (q == empty) return for_each(p, visit);
    const Node &of_p = nodes_[p], &of_q = nodes_[q];
    if (of_p.is_leaf()) {
      if (!contains(q, of_p.prefix)) visit(of_p.prefix);
    } else if (of_q.is_leaf() || (of_p.covers(of_q.prefix) && of_p.bit() > of_q.bit())) {
      const bool left = of_p.covers(of_q.prefix) && of_p.is_left(of_q.prefix);
      const bool right = of_p.covers(of_q.prefix) && !of_p.is_left(of_q.prefix);
      for_each_only_in(of_p.left, left ? q : empty, visit);
      for_each_only_in(of_p.right, right ? q : empty, visit);
    } else if (of_p.prefix == of_q.prefix) {
      for_each_only_in(of_p.left, of_q.left, visit);
      for_each_only_in(of_p.right, of_q.right, visit);
    } else if (of_q.covers(of_p.prefix)) {
      for_each_only_in(p, of_q.is_left(of_p.prefix) ? of_q.left : of_q.right, visit);
    } else {
      for_each(p, visit);
    }
  }

  /// Calls visit(source) for each source that is in both, in order. REQUIRES: each source counts once.
  template <class Visit>
  void for_each_in_both(Set p, Set q, const Visit& visit) const {
    if (p == q) return for_each(p, visit);
    for_each(p, [&](std::uint32_t source) {
      if (contains(q, source)) visit(source);
    });
  }

 private:
  /// Of a branch `prefix` has the bits that its sources share, then a 1 in place of the first bit in which they differ,
  /// then zeros.
  struct Node {
    std::uint32_t prefix;  ///< of a leaf: the source
    Set left;              ///< of a leaf: how often it counts, as an unsigned number
    Set right;             ///< of a leaf: empty
    std::uint32_t size;
    bool is_plain;  ///< each source counts once

    bool is_leaf() const { return right == empty; }
    std::int32_t count() const { return static_cast<std::int32_t>(left); }
    std::uint32_t bit() const { return prefix & -prefix; }
    bool covers(std::uint32_t source) const { return ((source ^ prefix) & ~(2 * bit() - 1)) == 0; }
    bool is_left(std::uint32_t source) const { return (source & bit()) == 0; }
  };

  Set combined(Set p, Set q, std::int32_t sign);
  Set negated(Set set);
  Set leaf(std::uint32_t source, std::int32_t count);
  Set branch(std::uint32_t prefix, Set left, Set right);
  /// A branch over two sets of which neither covers the other one's prefix.
  Set fork(std::uint32_t prefix_of_p, Set p, std::uint32_t prefix_of_q, Set q);
  Set keep(const Node& node);
  void grow();

  static constexpr Set unknown = none;

  std::int32_t least_;
  Array<Node> nodes_;           ///< the first one stands for the empty set
  Array<Set> members_;          ///< by node; unknown where nobody asked
  Array<std::uint32_t> slots_;  ///< hash table of nodes; 0 where free
};

}  // namespace oblast::internal
