// Lee's hull of one polygon against the monotone chain's.
#pragma once

#include <oblast/point.h>

#include <string>
#include <vector>

namespace oblast::tests {

/// By the monotone chain.
std::vector<Point> chain_hull(const std::vector<Point>& points);

/// Empty if Lee's scan and `oblast::hull` give the same corners as the monotone chain; otherwise the fault.
/// `ring`: simple, no repeated neighbours.
std::string compare_hulls(const std::vector<Point>& ring);

/// True when the contour is simple: no two edges meet but at their common end (a test of the generators).
bool is_simple(const std::vector<Point>& ring);

}  // namespace oblast::tests
