// WKT of region sets, unchanged, for printed failures and for cases in text files. Needs no GDAL.
#pragma once

#include <oblast/region_set.h>

#include <string>

namespace oblast::generators {

/// MULTIPOLYGON of the soup (rings closed by repeating their first vertex), shortest digits that read
/// back to the same bits.
std::string soup_to_wkt(const RegionView& soup);

/// Reads POLYGON or MULTIPOLYGON, or one that is EMPTY. Throws std::invalid_argument.
RegionSet soup_from_wkt(const std::string& text);

}  // namespace oblast::generators
