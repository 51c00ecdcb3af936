// A case once more by exact arithmetic: too slow for every case, so it is asked for in a share of them.
#pragma once

#include <optional>
#include <string>

#include "generators/hostile.h"
#include "generators/request.h"

namespace oblast::generators {

/// Recomputing more vertices than these, of operands and result together, takes tenths of a second. Cases of up to 60
/// edges have fewer, but for a few in a thousand.
inline constexpr std::size_t vertices_recomputed_at_most = 1000;

/// What is wrong with `result`, A op B as the library gave it, by verify::check_against, where there are at most
/// `most_vertices` in all. Cost: quadratic in the edges, and by each wrong place once more in the edges.
std::optional<std::string> recompute_result(const Operands& operands, const Request& request, Operation operation,
                                            const RegionSet& result,
                                            std::size_t most_vertices = vertices_recomputed_at_most);

/// What is wrong with the noded edges and what is chosen from them (stages 2 to 5), by verify::NodedArrangement: they
/// are settled; each operation's contours enclose exactly the area that the winding numbers say; and the areas add up
/// exactly: |A or B| + |A and B| = |A| + |B| and its likes. Quadratic in the noded edges.
std::optional<std::string> recompute_arrangement(const Operands& operands, const Request& request);

}  // namespace oblast::generators
