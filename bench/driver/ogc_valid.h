// Validity as the OGC defines it, decided by GEOS.
#pragma once

#include <oblast/region_set.h>

#include <string>

namespace oblast::bench {

enum class SelfTouching { refuse, admit };

/// Empty if the polygons form a valid MultiPolygon, otherwise the reason. The OGC does not allow rings that touch
/// themselves at a point; with `admit`, such rings may enclose holes.
std::string ogc_fault(const RegionView& regions, SelfTouching rings);

}  // namespace oblast::bench
