// Step 3 of zones: sites on the free edges, dense enough.
//
// A piece is a part of a free edge between two sites, with no site between them. It is short enough if at every place y
// that belongs to a site of another object, the piece is not nearer than that site, but for epsilon: then a place never
// belongs to an object that is further away than the piece, by more than epsilon. docs/zones.md has the proof that it
// suffices to look at the centres of triangles, and at the places where the border of a cell crosses the piece.
//
// Each round makes the diagram of the sites that there are and divides all pieces that are too long.
#pragma once

#include <cstdint>

#include "zones/diagram.h"
#include "zones/skeleton.h"

namespace oblast::internal::zoning {

struct Sampled {
  Diagram diagram;     ///< of sites that are dense enough
  Array<bool> narrow;  ///< by free edge: whether it may pass through cells of other objects
  std::uint64_t sites = 0;
  std::uint64_t rounds = 0;
  double error = 0;  ///< the largest epsilon that some piece needs
};

Sampled sample(const Skeleton& skeleton, const Room& room);

}  // namespace oblast::internal::zoning
