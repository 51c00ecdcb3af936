// An exact checker of triangulations: is it one, is it Delaunay as far as its constraints allow?
#pragma once

#include <oblast/triangulate.h>

#include <optional>
#include <span>
#include <string>

#include "triangulation/constrain.h"
#include "triangulation/mesh.h"

namespace oblast::testing {
using namespace internal;

/// The first fault, in words; none when
/// - twins are mutual and join the same two vertices, constrained marks agree on both sides;
/// - every triangle turns left, and the hull never turns right (exactly);
/// - there are 2 v - 2 triangles, ghosts included, and every vertex is in one;
/// - the triangles' areas sum up to the hull's (exactly);
/// - every side without a constraint is Delaunay (exactly);
/// - every constraint is a side with its mark, and no other side has one.
std::optional<std::string> check_mesh(const triangulation::Mesh& mesh,
                                      std::span<const triangulation::Constraint> constraints);

/// The same of a public triangulation with TriangleExtent::convex_hull, and that each triangle's
/// polygon is the one it lies in: areas by polygon agree exactly.
std::optional<std::string> check_triangulation(const Triangulation& triangulation);

}  // namespace oblast::testing
