// The rows of zones: what was noded, and the whole cells beside it.
#pragma once

#include <oblast/features.h>

#include <cstdint>

#include "features/keyed_overlay.h"
#include "zones/whole_cells.h"

namespace oblast::internal::zoning {

/// Whether the row `rest` has just the outline of the whole cells.
bool has_outline(const KeyedResult& noded, std::uint32_t rest, const WholeCells& cells);

/// A row for each object: its whole cell, or what was noded.
FeatureSet rows_of(KeyedResult noded, const WholeCells& cells, std::uint32_t objects);

}  // namespace oblast::internal::zoning
