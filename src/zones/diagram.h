// The Voronoi diagram of sites: the Delaunay triangulation, and a place for the centre of each triangle.
#pragma once

#include <cstdint>
#include <span>

#include "base/large_pages.h"
#include "triangulation/mesh.h"
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

struct Diagram {
  Mesh mesh;
  Array<std::uint32_t> object;   ///< by vertex: the lowest one of the sites that are there
  Array<std::uint32_t> contact;  ///< by vertex: that of this site; empty if there are no contacts
  LargeArray<Point> centre;      ///< by triangle; anything for those with the vertex at infinity

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

/// Centres are correctly rounded circumcentres, but for three sites of one contact: then the contact.
Diagram make_diagram(std::span<const Site> sites, std::span<const Contact> contacts);

}  // namespace oblast::internal::zoning
