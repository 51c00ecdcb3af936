// GEOS (OverlayNG) through its C API.
#include <geos_c.h>

#include <memory>
#include <vector>

#include "driver/rectangle.h"

namespace {

using namespace oblast;
using bench::OperandKind;

void collect_message(const char* message, void* text) { *static_cast<std::string*>(text) = message; }

struct Geos {
  static std::string name() { return "geos"; }
  static std::string version() { return GEOSversion(); }

  // Here geometries outlive the context that made them. Their destruction needs some context.
  struct Destroy {
    void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy(geometry); }
  };
  using Geometry = std::unique_ptr<GEOSGeometry, Destroy>;
  struct Prepared {
    Geometry a, b;
  };

  explicit Geos(const bench::Settings& settings) : settings_(settings), context_(GEOS_init_r()) {
    static const bool ready = (initGEOS(nullptr, nullptr), true);  // for Destroy
    (void)ready;
    GEOSContext_setErrorMessageHandler_r(context_, collect_message, &message_);
  }
  ~Geos() { GEOS_finish_r(context_); }
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;

  Prepared prepare(const RegionView& a, const RegionView& b) { return {geometry(a), geometry(b)}; }

  void run(const Prepared& input, RegionSet& result) {
    if (settings_.unary && settings_.kind_a != OperandKind::crossing) {
      const Geometry united = checked(settings_.coverage ? GEOSCoverageUnion_r(context_, input.a.get())
                                                         : GEOSUnaryUnion_r(context_, input.a.get()));
      extract(united.get(), result);
      return;
    }
    const Geometry a = resolved(input.a.get(), settings_.kind_a);
    const Geometry b = resolved(input.b.get(), settings_.kind_b);
    const GEOSGeometry* left = a ? a.get() : input.a.get();
    const GEOSGeometry* right = b ? b.get() : input.b.get();
    Geometry overlaid;
    switch (settings_.operation) {
      case Operation::intersection:
        overlaid = checked(GEOSIntersection_r(context_, left, right));
        break;
      case Operation::unite:
        overlaid = checked(GEOSUnion_r(context_, left, right));
        break;
      case Operation::difference:
        overlaid = checked(GEOSDifference_r(context_, left, right));
        break;
      case Operation::symmetric_difference:
        overlaid = checked(GEOSSymDifference_r(context_, left, right));
        break;
    }
    extract(overlaid.get(), result);
  }

 protected:
  bench::Settings settings_;

  Geometry checked(GEOSGeometry* geometry) {
    if (geometry == nullptr) throw std::runtime_error(message_.empty() ? "no result" : message_);
    return Geometry(geometry);
  }

  // GEOS overlays valid geometries only. Invalid ones are made valid first; this is timed.
  Geometry resolved(const GEOSGeometry* operand, OperandKind kind) {
    if (kind == OperandKind::overlapping) return checked(GEOSUnaryUnion_r(context_, operand));
    if (kind == OperandKind::region_set) return {};
    if (settings_.fill != FillRule::Kind::even_odd) {
      throw bench::Unsupported("contours that cross themselves have only an even-odd meaning (GEOSMakeValid)");
    }
    return checked(GEOSMakeValid_r(context_, operand));
  }

  GEOSGeometry* ring(std::span<const Point> contour) {
    const auto count = static_cast<unsigned>(contour.size());
    GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(context_, count + 1, 2);
    for (unsigned i = 0; i <= count; ++i) {
      const Point& p = contour[i % count];
      GEOSCoordSeq_setXY_r(context_, sequence, i, p.x, p.y);
    }
    return GEOSGeom_createLinearRing_r(context_, sequence);
  }

  Geometry geometry(const RegionView& regions) {
    std::vector<GEOSGeometry*> polygons;
    for (std::size_t p = 0; p < regions.polygon_count(); ++p) {
      std::vector<GEOSGeometry*> rings;
      for (std::uint32_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c) {
        rings.push_back(ring(regions.contour(c)));
      }
      polygons.push_back(
          GEOSGeom_createPolygon_r(context_, rings[0], rings.data() + 1, static_cast<unsigned>(rings.size() - 1)));
    }
    if (polygons.size() == 1) return Geometry(polygons[0]);
    // The polygons of a coverage may not form a MultiPolygon. GEOSCoverageUnion expects a collection of polygons.
    const int type = settings_.coverage ? GEOS_GEOMETRYCOLLECTION : GEOS_MULTIPOLYGON;
    return checked(
        GEOSGeom_createCollection_r(context_, type, polygons.data(), static_cast<unsigned>(polygons.size())));
  }

  void extract_ring(const GEOSGeometry* ring, RegionSet& result) {
    const GEOSCoordSequence* sequence = GEOSGeom_getCoordSeq_r(context_, ring);
    unsigned count = 0;
    GEOSCoordSeq_getSize_r(context_, sequence, &count);
    const std::size_t begin = result.points.size();
    result.points.resize(begin + count);
    GEOSCoordSeq_copyToBuffer_r(context_, sequence, &result.points[begin].x, 0, 0);
    result.points.pop_back();  // the closing point
    result.contour_ends.push_back(static_cast<std::uint32_t>(result.points.size()));
  }

  // Extracts the polygons of a result. Lines and points in a mixed result have no area and are ignored.
  void extract(const GEOSGeometry* geometry, RegionSet& result) {
    const int type = GEOSGeomTypeId_r(context_, geometry);
    if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION) {
      const int parts = GEOSGetNumGeometries_r(context_, geometry);
      for (int i = 0; i < parts; ++i) extract(GEOSGetGeometryN_r(context_, geometry, i), result);
      return;
    }
    if (type != GEOS_POLYGON || GEOSisEmpty_r(context_, geometry)) return;
    extract_ring(GEOSGetExteriorRing_r(context_, geometry), result);
    const int holes = GEOSGetNumInteriorRings_r(context_, geometry);
    for (int i = 0; i < holes; ++i) extract_ring(GEOSGetInteriorRingN_r(context_, geometry, i), result);
    result.polygon_ends.push_back(static_cast<std::uint32_t>(result.contour_ends.size()));
  }

  GEOSContextHandle_t context_;

 private:
  std::string message_;
};

// The same without the shortcut for coverages, which gives wrong results if borders do not match.
struct GeosUnary : Geos {
  static std::string name() { return "geos"; }
  explicit GeosUnary(bench::Settings settings) : Geos((settings.coverage = false, settings)) {}
};

struct GeosCoverage : Geos {
  static std::string name() { return "geos-coverage"; }
  explicit GeosCoverage(const bench::Settings& settings) : Geos(settings) {
    if (!settings.coverage) throw bench::Unsupported("only for coverages");
  }
};

// GEOS's clip by a rectangle, without noding.
struct GeosRect : Geos {
  static std::string name() { return "geos-rect"; }
  using Geos::Geos;

  struct Prepared {
    Geometry a;
    bench::Rectangle window;
  };
  Prepared prepare(const RegionView& a, const RegionView& b) {
    const bench::Rectangle window = bench::clip_rectangle(settings_, b);
    return {geometry(a), window};
  }
  void run(const Prepared& input, RegionSet& result) {
    const bench::Rectangle& w = input.window;
    const Geometry clipped = checked(GEOSClipByRect_r(context_, input.a.get(), w.x0, w.y0, w.x1, w.y1));
    extract(clipped.get(), result);
  }
};

}  // namespace

int main(int argc, char** argv) {
#ifdef OBLAST_GEOS_RECT
  return bench::drive<GeosRect>(argc, argv);
#elif defined(OBLAST_GEOS_COVERAGE)
  return bench::drive<GeosCoverage>(argc, argv);
#else
  return bench::drive<GeosUnary>(argc, argv);
#endif
}
