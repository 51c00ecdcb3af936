// The treap over the active edges.
#include "engines/vatti/active_edges.h"

#include <cassert>

namespace oblast::internal::vatti {

Slot ActiveEdges::find_below(const Point& p) {
  Slot found = ground;
  for (Slot slot = nodes_[ground].right; slot != none;) {
    Node& node = nodes_[slot];
    ActiveEdge& edge = node.edge;
    while (edge.vertex != edge.last && !lexicographically_less(p, edge.b)) {
      edge.a = edge.b;
      edge.b = points_[edge.vertex += edge.step];
    }
    const int side = exact::orientation(edge.a, edge.b, p);
    assert(side != 0);
    if (side > 0) found = slot;
    slot = side > 0 ? node.right : node.left;
  }
  return found;
}

Slot ActiveEdges::new_slot() {
  if (free_ == none) {
    nodes_.emplace_back();
    return static_cast<Slot>(nodes_.size() - 1);
  }
  const Slot slot = free_;
  free_ = nodes_[slot].next;
  return slot;
}

Slot ActiveEdges::insert_above(Slot slot, const ActiveEdge& edge) {
  const Slot added = new_slot();
  random_ ^= random_ << 13, random_ ^= random_ >> 17, random_ ^= random_ << 5;  // Marsaglia's xorshift
  const Slot next = nodes_[slot].next;
  // Of two neighbours in the order, one is an ancestor of the other, so one of the two places between them is free.
  const bool as_right = nodes_[slot].right == none;
  const Slot parent = as_right ? slot : next;
  nodes_[added] = {edge, parent, none, none, slot, next, random_ >> 1};
  (as_right ? nodes_[parent].right : nodes_[parent].left) = added;
  nodes_[slot].next = added;
  if (next != none) nodes_[next].previous = added;
  while (nodes_[nodes_[added].parent].priority < nodes_[added].priority) rotate_up(added);
  return added;
}

void ActiveEdges::replace_child(Slot parent, Slot child, Slot by) {
  (nodes_[parent].left == child ? nodes_[parent].left : nodes_[parent].right) = by;
  if (by != none) nodes_[by].parent = parent;
}

//        parent               slot
//        /    \               /    \.
//     slot     c     to      a    parent       and its mirror image
//     /  \                         /   \.
//    a    b                       b     c
void ActiveEdges::rotate_up(Slot slot) {
  const Slot parent = nodes_[slot].parent;
  const bool is_left = nodes_[parent].left == slot;
  Slot& inner = is_left ? nodes_[slot].right : nodes_[slot].left;
  replace_child(nodes_[parent].parent, parent, slot);
  (is_left ? nodes_[parent].left : nodes_[parent].right) = inner;
  if (inner != none) nodes_[inner].parent = parent;
  inner = parent;
  nodes_[parent].parent = slot;
}

void ActiveEdges::erase(Slot slot) {
  Node& node = nodes_[slot];
  while (node.left != none && node.right != none)
    rotate_up(nodes_[node.left].priority > nodes_[node.right].priority ? node.left : node.right);
  replace_child(node.parent, slot, node.left != none ? node.left : node.right);
  nodes_[node.previous].next = node.next;
  if (node.next != none) nodes_[node.next].previous = node.previous;
  node.next = free_;
  free_ = slot;
}

}  // namespace oblast::internal::vatti
