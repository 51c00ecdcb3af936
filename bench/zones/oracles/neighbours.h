// The comparison of zones of points with a Delaunay triangulation (bench/zones/oracle --points).
//
// A file of neighbours, by neighbours_by_cgal.cpp:
//   u64   pairs, vertices
//   u32   i, j of each pair, i < j, ascending: numbers of points whose cells share a border of positive length in the
//   frame f64   the length of each border, up to rounding f64   x y of each vertex of the diagram inside the frame,
//   correctly rounded, ascending, each once
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace zones {

/// Makes the zones of the points; proves that they are a coverage; compares their pairs of neighbours, the lengths of
/// the borders, and their vertices inside the frame. What differs by less than C (ZoneStatistics::rounding), because
/// vertices are rounded, is counted apart.
nlohmann::json judge_neighbours(const std::string& shapes, const std::string& neighbours);

}  // namespace zones
