// Recomputes a case with exact arithmetic. This is too slow for every case, so it is done for a share of them.
#pragma once

#include <optional>
#include <string>

#include "generators/hostile.h"
#include "generators/request.h"

namespace oblast::generators {

/// Recomputing more vertices than this, of operands and result together, takes tenths of a second. Cases of up to 60
/// edges have fewer, except for a few in a thousand.
inline constexpr std::size_t vertices_recomputed_at_most = 1000;

/// The fault of `result`, the library's A op B, that verify::check_against finds; nothing for more than `most_vertices`
/// vertices in total. Cost: quadratic in the edges; each wrong place adds a factor of the number of edges.
std::optional<std::string> recompute_result(const Operands& operands, const Request& request, Operation operation,
                                            const RegionSet& result,
                                            std::size_t most_vertices = vertices_recomputed_at_most);

/// The fault of stages 2 to 5 that verify::NodedArrangement finds. It checks that the noded edges are settled, that the
/// contours of each operation enclose exactly the area that the winding numbers give, and that the areas add up
/// exactly, such as |A or B| + |A and B| = |A| + |B|. Cost: quadratic in the noded edges.
std::optional<std::string> recompute_arrangement(const Operands& operands, const Request& request);

}  // namespace oblast::generators
