#include "noding/source_sets.h"

#include <algorithm>
#include <bit>

namespace oblast::internal {
namespace {

std::uint64_t hash(std::uint32_t prefix, std::uint32_t left, std::uint32_t right) {
  std::uint64_t h = (prefix * 0x9e3779b97f4a7c15ULL) ^ (left | std::uint64_t{right} << 32);
  h *= 0xd6e8feb86659fd93ULL;
  return h ^ h >> 32;
}

}  // namespace

SourceSets::SourceSets(std::int32_t least) : least_(least), nodes_(1, Node{0, 0, 0, 0, true}) { grow(); }

SourceSets::Set SourceSets::changed(Set set, std::uint32_t source, std::int32_t by) {
  if (set == empty) return leaf(source, by);
  const Node node = nodes_[set];
  if (node.is_leaf()) {
    if (node.prefix == source) return leaf(source, node.count() + by);
    return fork(source, leaf(source, by), node.prefix, set);
  }
  if (!node.covers(source)) return fork(source, leaf(source, by), node.prefix, set);
  // At most 32 calls deep: each goes on with fewer bits.
  if (node.is_left(source)) return branch(node.prefix, changed(node.left, source, by), node.right);
  return branch(node.prefix, node.left, changed(node.right, source, by));
}

SourceSets::Set SourceSets::members(Set set) {
  if (set == empty) return empty;
  const Node node = nodes_[set];
  if (node.is_plain && least_ == 1) return set;
  if (node.is_leaf()) return node.count() >= least_ ? leaf(node.prefix, 1) : empty;
  if (set < members_.size() && members_[set] != unknown) return members_[set];
  const Set left = members(node.left), right = members(node.right);
  const Set found = branch(node.prefix, left, right);
  if (members_.size() <= set) members_.resize(nodes_.size(), unknown);
  return members_[set] = found;
}

SourceSets::Set SourceSets::combined(Set p, Set q, std::int32_t sign) {
  if (q == empty) return p;
  if (p == empty) return sign > 0 ? q : negated(q);
  const Node of_p = nodes_[p], of_q = nodes_[q];
  if (of_q.is_leaf()) return changed(p, of_q.prefix, sign * of_q.count());
  if (of_p.is_leaf()) return changed(sign > 0 ? q : negated(q), of_p.prefix, of_p.count());
  if (of_p.prefix == of_q.prefix)
    return branch(of_p.prefix, combined(of_p.left, of_q.left, sign), combined(of_p.right, of_q.right, sign));
  if (of_p.bit() > of_q.bit() && of_p.covers(of_q.prefix)) {
    if (of_p.is_left(of_q.prefix)) return branch(of_p.prefix, combined(of_p.left, q, sign), of_p.right);
    return branch(of_p.prefix, of_p.left, combined(of_p.right, q, sign));
  }
  if (of_q.bit() > of_p.bit() && of_q.covers(of_p.prefix)) {
    const bool left = of_q.is_left(of_p.prefix);
    const Set beside = left ? of_q.right : of_q.left, within = combined(p, left ? of_q.left : of_q.right, sign);
    const Set other = sign > 0 ? beside : negated(beside);
    return left ? branch(of_q.prefix, within, other) : branch(of_q.prefix, other, within);
  }
  return fork(of_p.prefix, p, of_q.prefix, sign > 0 ? q : negated(q));
}

SourceSets::Set SourceSets::negated(Set set) {
  if (set == empty) return empty;
  const Node node = nodes_[set];
  if (node.is_leaf()) return leaf(node.prefix, -node.count());
  const Set left = negated(node.left), right = negated(node.right);
  return branch(node.prefix, left, right);
}

bool SourceSets::contains(Set set, std::uint32_t source) const {
  while (set != empty) {
    const Node& node = nodes_[set];
    if (node.is_leaf()) return node.prefix == source;
    if (!node.covers(source)) return false;
    set = node.is_left(source) ? node.left : node.right;
  }
  return false;
}

std::uint32_t SourceSets::lowest(Set set) const {
  while (!nodes_[set].is_leaf()) set = nodes_[set].left;
  return nodes_[set].prefix;
}

SourceSets::Set SourceSets::leaf(std::uint32_t source, std::int32_t count) {
  if (count == 0) return empty;
  return keep({source, static_cast<std::uint32_t>(count), empty, 1, count == 1});
}

SourceSets::Set SourceSets::branch(std::uint32_t prefix, Set left, Set right) {
  if (left == empty) return right;
  if (right == empty) return left;
  const Node &l = nodes_[left], &r = nodes_[right];
  return keep({prefix, left, right, l.size + r.size, l.is_plain && r.is_plain});
}

SourceSets::Set SourceSets::fork(std::uint32_t prefix_of_p, Set p, std::uint32_t prefix_of_q, Set q) {
  if (p == empty) return q;
  const std::uint32_t bit = std::bit_floor(prefix_of_p ^ prefix_of_q);
  const std::uint32_t prefix = (prefix_of_p & ~(2 * bit - 1)) | bit;
  return (prefix_of_p & bit) == 0 ? branch(prefix, p, q) : branch(prefix, q, p);
}

SourceSets::Set SourceSets::keep(const Node& node) {
  if (2 * nodes_.size() > slots_.size()) grow();
  std::uint64_t slot = hash(node.prefix, node.left, node.right);
  for (;; ++slot) {
    const std::uint32_t i = slots_[slot & (slots_.size() - 1)];
    if (i == 0) break;
    const Node& other = nodes_[i];
    if (other.prefix == node.prefix && other.left == node.left && other.right == node.right) return i;
  }
  const std::uint32_t i = checked_index(nodes_.size(), "sets of rows");
  nodes_.push_back(node);
  slots_[slot & (slots_.size() - 1)] = i;
  return i;
}

void SourceSets::grow() {
  slots_.assign(std::max<std::size_t>(64, 2 * slots_.size()), 0);
  for (std::uint32_t i = 1; i < nodes_.size(); ++i) {
    std::uint64_t slot = hash(nodes_[i].prefix, nodes_[i].left, nodes_[i].right);
    while (slots_[slot & (slots_.size() - 1)] != 0) ++slot;
    slots_[slot & (slots_.size() - 1)] = i;
  }
}

}  // namespace oblast::internal
