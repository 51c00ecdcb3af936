// The Voronoi diagram of sites: the Delaunay triangulation, and a place for the centre of each triangle.
#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include "base/large_pages.h"
#include "triangulation/growing_delaunay.h"
#include "zones/skeleton.h"

namespace oblast::internal::zoning {

using triangulation::HalfEdge;
using triangulation::Mesh;

/// A point that stands for an object.
struct Site {
  Point at;
  std::uint32_t object;          ///< none: the far outside
  std::uint32_t contact = none;  ///< if it is at the radius of one
};

/// The circle of a triangle: no site is inside.
struct Circle {
  Point centre;
  double radius;
};

struct Diagram {
  Mesh mesh;
  Array<std::uint32_t> object;   ///< by vertex: the lowest one of the sites that are there
  Array<std::uint32_t> contact;  ///< by vertex: that of this site; empty if there are no contacts
  Array<HalfEdge> leaving;       ///< by vertex: some half-edge with that origin
  LargeArray<Circle> circle;     ///< by triangle; anything for those with the vertex at infinity

  /// The contact that all three vertices are at, or both ends of the side; none if there is none.
  std::uint32_t contact_of(std::uint32_t triangle) const {
    const auto [a, b, c] = mesh.triangles[triangle].vertex;
    return contact.empty() || contact[a] != contact[b] || contact[b] != contact[c] ? none : contact[a];
  }
  std::uint32_t contact_across(HalfEdge h) const {
    const std::uint32_t a = mesh.origin(h), b = mesh.target(h);
    return contact.empty() || contact[a] != contact[b] ? none : contact[a];
  }
  bool is_border(HalfEdge h) const { return object[mesh.origin(h)] != object[mesh.target(h)]; }
};

/// A diagram that grows by batches of sites. Centres are correctly rounded circumcentres, but for three sites of one
/// contact: then the contact.
class GrowingDiagram {
 public:
  explicit GrowingDiagram(std::span<const Contact> contacts) : contacts_(contacts), delaunay_(diagram_.mesh) {}
  GrowingDiagram(const GrowingDiagram&) = delete;
  GrowingDiagram& operator=(const GrowingDiagram&) = delete;

  /// Sites are numbered through all batches. REQUIRES: three sites of the first batch are not collinear.
  void add(std::span<const Site> sites);

  const Diagram& diagram() const { return diagram_; }
  std::uint32_t vertex_of(std::uint32_t site) const { return diagram_.mesh.vertex_of[site]; }
  /// Whether the last batch changed the triangle or one beside it, or the object of one of its vertices.
  bool is_near_change(std::uint32_t triangle) const { return delaunay_.is_near_change(triangle); }

  Diagram take() { return std::move(diagram_); }

 private:
  void give_objects(std::span<const Site> sites, std::size_t first_site, std::size_t first_vertex);
  void update(std::uint32_t triangle);

  std::span<const Contact> contacts_;
  Diagram diagram_;
  triangulation::GrowingDelaunay delaunay_;
};

}  // namespace oblast::internal::zoning
