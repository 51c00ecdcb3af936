// A Delaunay triangulation that grows by batches of points, and says what each batch changed.
//
// For each point, in spatial order (spatial_order.h): walk from the triangle made last to the triangle that contains
// the point. Divide that triangle, or the two triangles at the side on which the point lies. Then flip sides that are
// not Delaunay (Lawson), with an explicit stack. Exact predicates make all decisions, so collinear, cocircular and
// equal points need no special treatment.
#pragma once

#include <span>

#include "base/call.h"
#include "triangulation/mesh.h"

namespace oblast::internal::triangulation {

class GrowingDelaunay {
 public:
  /// `mesh` is empty, and changed by add() alone.
  explicit GrowingDelaunay(Mesh& mesh) : mesh_(mesh) {}

  /// Inserts points; vertex_of grows by one for each. False, with nothing done, if the first batch has no three points
  /// that are not collinear. REQUIRES: as delaunay(). Cost: as delaunay() for the batch; the walks of a small batch are
  /// long, on average the root of how many times as large the mesh is.
  bool add(std::span<const Point> points);

  /// The triangles that the last batch made or changed, each once; empty after the first batch, which makes all.
  std::span<const std::uint32_t> changed() const { return changed_; }

  /// Whether the last batch changed the triangle, or one beside it. Triangle::mark holds this.
  bool is_near_change(std::uint32_t triangle) const { return mesh_.triangles[triangle].mark >> 1 == batch_; }

  /// From here on the triangle counts as one beside a change.
  void touch(std::uint32_t triangle);

 private:
  void gather(std::span<const Point> points);
  bool find_three();
  void first_triangle();
  std::uint32_t add_vertex(std::uint32_t i);
  void swap_places(std::size_t i, std::size_t j);
  void insert(std::uint32_t i, Steps& flips);
  std::uint32_t add_triangle();
  void make(std::uint32_t t, std::uint32_t p, std::uint32_t a, std::uint32_t b, HalfEdge beyond);
  void join_around(std::uint32_t before, std::uint32_t after);
  void part_triangle(std::uint32_t t, std::uint32_t p);
  void part_side(HalfEdge h, std::uint32_t p);
  void flip_illegal(std::uint32_t p, Steps& flips);
  bool is_illegal(const Triangle& t, std::uint32_t p, std::uint32_t c) const;
  void note_changed(std::uint32_t t);
  void set_outer_twin(HalfEdge h, HalfEdge twin);

  Mesh& mesh_;                  ///< points: the vertices, then those of the batch that are not yet inserted, in order
  Array<std::uint32_t> order_;  ///< indices of the points of the batch
  std::uint32_t begin_ = 0;     ///< the place of the first point of the batch in the mesh
  std::size_t given_ = 0;       ///< points of earlier batches
  std::uint32_t vertices_ = 0;
  std::uint32_t batch_ = 0;        ///< the number of the last one, from 0
  Array<std::uint32_t> changed_;   ///< triangles
  Array<std::uint32_t> suspects_;  ///< triangles whose side 1 may be illegal
  std::uint32_t last_ = 0;         ///< the triangle in which the next walk begins
};

}  // namespace oblast::internal::triangulation
