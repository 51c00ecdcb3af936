// Stage 3 by Leonov and Nikitin (preprint 46, 1997): labels carried around vertices and along chains.
#pragma once

#include <vector>

#include "overlay/chain_graph.h"

namespace oblast::leonov_nikitin {

/// By chain: the winding numbers of A and B on its right side; the left side is that plus its change.
/// Meaningful for live chains only. Cost: O(k + z log z), z connected components.
std::vector<Winding> label(const ChainGraph& graph);

}  // namespace oblast::leonov_nikitin
