// Contours prepared for comparison: they are clean and classified, and each has a tree of boxes over its edges.
//
//              [ 1 ]               The nodes of a tree: 1 is the root; 2 i and 2 i + 1 are below i. The leaves
//         [ 2 ]     [ 3 ]          are leaf_count to 2 leaf_count - 1, and have eight consecutive edges each.
//       [ 4 ] [5] [ 6 ] [7]        Leaves that are not needed are empty and meet nothing.
#pragma once

#include <oblast/region_set.h>

#include <cstdint>
#include <span>

#include "base/call_memory.h"
#include "base/tuning.h"
#include "noding/simple_ring.h"
#include "plane/box.h"

namespace oblast::internal {

/// A view of one contour. Edge e runs from vertex e to the next vertex.
struct ContourTree {
  static constexpr std::uint32_t edges_a_leaf = tuning::contour_edges_a_leaf;

  std::span<const Point> ring;
  RingShape shape;
  std::uint32_t leaf_count;    ///< a power of two
  std::span<const Box> nodes;  ///< node i at i - 1

  const Box& box() const { return nodes[0]; }
  const Box& box_of(std::uint32_t node) const { return nodes[node - 1]; }
  bool is_leaf(std::uint32_t node) const { return node >= leaf_count; }
  std::uint32_t first_edge(std::uint32_t leaf) const { return (leaf - leaf_count) * edges_a_leaf; }
  std::uint32_t last_edge(std::uint32_t leaf) const {
    const std::uint32_t past = first_edge(leaf) + edges_a_leaf, size = static_cast<std::uint32_t>(ring.size());
    return past < size ? past : size;
  }
  const Point& next(std::uint32_t vertex) const { return ring[vertex + 1 == ring.size() ? 0 : vertex + 1]; }
  const Point& previous(std::uint32_t vertex) const { return ring[vertex == 0 ? ring.size() - 1 : vertex - 1]; }
};

class ContourTrees {
 public:
  /// Cost: O(v log v); linear if the contours are convex.
  explicit ContourTrees(const RegionView& operand);

  std::size_t size() const { return contours_.size(); }
  /// False if the clean contour has fewer than three vertices; then it has no tree.
  bool has_interior(std::size_t c) const { return contours_[c].leaf_count > 0; }
  ContourTree operator[](std::size_t c) const;

 private:
  struct Entry {
    std::uint32_t first_point, point_count;
    std::uint32_t first_node, leaf_count;
    RingShape shape;
  };

  void add(std::span<const Point> contour);
  void add_tree(std::span<const Point> ring, std::uint32_t leaf_count);

  Array<Point> points_;
  Array<Box> nodes_;
  Array<Entry> contours_;
};

}  // namespace oblast::internal
