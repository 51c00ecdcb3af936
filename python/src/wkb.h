// Many geometries in Well-Known Binary, on all cores.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "call.h"

namespace oblast::python {

using Wkb = std::span<const std::byte>;

/// A row for each geometry; an empty span is a row without polygons. An error has the row. `has_z` becomes true if a
/// geometry has Z or M, which are ignored.
FeatureSet read_rows(const std::vector<Wkb>& geometries, const Settings& settings, bool& has_z);

}  // namespace oblast::python
