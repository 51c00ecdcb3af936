// Validity as the OGC defines it, in GEOS's judgement.
#pragma once

#include <oblast/region_set.h>

#include <string>

namespace oblast::bench {

enum class SelfTouching { refuse, admit };

/// Empty where the polygons form a valid MultiPolygon, else the reason. The OGC refuses rings that touch
/// themselves at a point; with `admit` such rings may enclose holes.
std::string ogc_fault(const RegionView& regions, SelfTouching rings);

}  // namespace oblast::bench
