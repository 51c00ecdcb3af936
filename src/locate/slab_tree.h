// A segment tree of horizontal slabs: how points are located where edges crowd.
//
//   ys   y0   y1   y2   y3        the different y of all vertices; between two of them lies a slab without vertices
//         \___/ \___/ \___/
//          \_____/               a node is a slab of one or of two halves; an edge is in the few nodes whose slabs
//              \_______/         make up its height, each of which it passes from side to side
//
// Edges that meet at vertices only are in one order along all of a node's slab, so how many pass left of a point is a
// binary search in each node above its slab. What is not in order, since edges cross, is looked at from end to end.
#pragma once

#include <oblast/locator.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "locate/edges.h"

namespace oblast::internal::locate {

class SlabTree {
 public:
  /// Besides the lists, which are charged when their length is known.
  static constexpr std::size_t bytes_an_edge = sizeof(Point) + 2 * sizeof(double) + 3 * sizeof(std::size_t);

  /// REQUIRES: the edges outlive it. Cost: O(n log n) memory, O(n log^2 n) time at worst.
  explicit SlabTree(const Edges& edges);

  /// Cost: O(log^2 n).
  Location locate(const Point& p) const;

 private:
  struct Segment {
    double y, x0, x1;
  };

  void list_vertices();
  void list_level_edges();
  void list_nodes();
  void sort_node(std::size_t node);
  bool is_at_vertex_or_level(const Point& p, std::size_t y) const;
  template <class Visit>
  void for_each_node(Index edge, const Visit& visit) const;
  std::size_t slab_of(double y) const;

  const Edges& edges_;
  std::vector<Point> vertices_;           ///< by y, then by x
  std::vector<double> ys_;                ///< the different ones
  std::vector<std::size_t> first_at_;     ///< by y: its first vertex
  std::vector<Segment> levels_;           ///< along y, joined where they overlap; by y, then by x
  std::vector<std::size_t> ends_;         ///< by node: where its list ends
  std::vector<Index> lists_;              ///< from left to right
  std::vector<std::uint8_t> is_ordered_;  ///< by node
};

}  // namespace oblast::internal::locate
