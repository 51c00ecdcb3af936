// Validity as the OGC defines it, through GEOS's C API.
#include "driver/ogc_valid.h"

#include <geos_c.h>

#include <stdexcept>
#include <vector>

namespace oblast::bench {
namespace {

GEOSGeometry* ring(GEOSContextHandle_t context, std::span<const Point> contour) {
  const auto count = static_cast<unsigned>(contour.size());
  GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(context, count + 1, 2);
  for (unsigned i = 0; i <= count; ++i) {
    GEOSCoordSeq_setXY_r(context, sequence, i, contour[i % count].x, contour[i % count].y);
  }
  GEOSGeometry* made = GEOSGeom_createLinearRing_r(context, sequence);
  if (made == nullptr) throw std::runtime_error("a contour that makes no ring");
  return made;
}

GEOSGeometry* multi_polygon(GEOSContextHandle_t context, const RegionView& regions) {
  std::vector<GEOSGeometry*> polygons;
  for (std::size_t p = 0; p < regions.polygon_count(); ++p) {
    std::vector<GEOSGeometry*> rings;
    for (std::uint32_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c) {
      if (regions.contour(c).size() < 3) throw std::runtime_error("a contour of fewer than three vertices");
      rings.push_back(ring(context, regions.contour(c)));
    }
    polygons.push_back(
        GEOSGeom_createPolygon_r(context, rings[0], rings.data() + 1, static_cast<unsigned>(rings.size() - 1)));
  }
  return GEOSGeom_createCollection_r(context, GEOS_MULTIPOLYGON, polygons.data(),
                                     static_cast<unsigned>(polygons.size()));
}

}  // namespace

std::string ogc_fault(const RegionView& regions, SelfTouching rings) {
  GEOSContextHandle_t context = GEOS_init_r();
  try {
    GEOSGeometry* geometry = multi_polygon(context, regions);
    const int flags = rings == SelfTouching::admit ? GEOSVALID_ALLOW_SELFTOUCHING_RING_FORMING_HOLE : 0;
    char* reason = nullptr;
    const bool valid = GEOSisValidDetail_r(context, geometry, flags, &reason, nullptr) == 1;
    const std::string text = reason != nullptr ? reason : "GEOS gives no reason";
    GEOSFree_r(context, reason);
    GEOSGeom_destroy_r(context, geometry);
    GEOS_finish_r(context);
    return valid ? "" : text;
  } catch (const std::exception& error) {
    GEOS_finish_r(context);
    return error.what();
  }
}

}  // namespace oblast::bench
