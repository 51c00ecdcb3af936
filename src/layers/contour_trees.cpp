// Prepares contours for comparison.
#include "layers/contour_trees.h"

#include <algorithm>
#include <bit>

#include "base/index.h"
#include "plane/empty_box.h"

namespace oblast::internal {
namespace {

Box join(const Box& p, const Box& q) {
  return {std::min(p.x0, q.x0), std::min(p.y0, q.y0), std::max(p.x1, q.x1), std::max(p.y1, q.y1)};
}

}  // namespace

ContourTrees::ContourTrees(const RegionView& operand) {
  points_.reserve(operand.points.size());
  contours_.reserve(operand.contour_count());
  for (std::size_t c = 0; c < operand.contour_count(); ++c) add(operand.contour(c));
}

void ContourTrees::add(std::span<const Point> contour) {
  const auto first = static_cast<std::uint32_t>(points_.size());
  for (const Point& p : contour)
    if (points_.size() == first || points_.back() != p) points_.push_back(p);
  while (points_.size() > first + 1 && points_.back() == points_[first]) points_.pop_back();
  const auto count = static_cast<std::uint32_t>(points_.size()) - first;
  const std::uint32_t first_node = checked_index(nodes_.size(), "boxes of contours");
  if (count < 3) {
    points_.resize(first);
    contours_.push_back({first, 0, first_node, 0, RingShape::tangled});
    return;
  }
  const std::span<const Point> ring(points_.data() + first, count);
  const std::uint32_t leaves = std::bit_ceil((count + ContourTree::edges_a_leaf - 1) / ContourTree::edges_a_leaf);
  contours_.push_back({first, count, first_node, leaves, ring_shape(ring)});
  add_tree(ring, leaves);
}

void ContourTrees::add_tree(std::span<const Point> ring, std::uint32_t leaf_count) {
  const std::size_t first = nodes_.size();
  nodes_.resize(first + 2 * leaf_count - 1, empty_box);
  const auto node = [&](std::size_t i) -> Box& { return nodes_[first + i - 1]; };
  for (std::size_t e = 0; e < ring.size(); ++e) {
    Box& leaf = node(leaf_count + e / ContourTree::edges_a_leaf);
    leaf = join(leaf, Box::of(ring[e], ring[e + 1 == ring.size() ? 0 : e + 1]));
  }
  for (std::size_t i = leaf_count - 1; i >= 1; --i) node(i) = join(node(2 * i), node(2 * i + 1));
}

ContourTree ContourTrees::operator[](std::size_t c) const {
  const Entry& e = contours_[c];
  return {{points_.data() + e.first_point, e.point_count},
          e.shape,
          e.leaf_count,
          {nodes_.data() + e.first_node, 2 * std::size_t{e.leaf_count} - 1}};
}

}  // namespace oblast::internal
