// Vertices of a triangulation that lie exactly on an edge from one vertex to another.
#pragma once

#include <cstdint>

#include "base/call_memory.h"
#include "triangulation/mesh.h"

namespace oblast::internal::zoning {

class VerticesOnEdges {
 public:
  /// REQUIRES: the mesh has triangles, is not changed while this exists, and has no constraints.
  explicit VerticesOnEdges(const triangulation::Mesh& mesh);

  /// Appends the vertices strictly between two vertices, in their order. Cost: linear in the triangles that the edge
  /// crosses, and in the degree of the ends and of these vertices.
  void between(std::uint32_t from, std::uint32_t to, Array<std::uint32_t>& found) const;

 private:
  bool is_side(std::uint32_t from, std::uint32_t to) const;
  std::uint32_t next_on(std::uint32_t from, std::uint32_t to) const;
  int side_of(std::uint32_t from, std::uint32_t to, std::uint32_t vertex) const;

  const triangulation::Mesh& mesh_;
  Array<triangulation::HalfEdge> leaving_;  ///< by vertex
};

}  // namespace oblast::internal::zoning
