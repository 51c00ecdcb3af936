// GEOS, prepared, by its C interface. Three ways, of which the best counts: `contains` and `intersects` of one prepared
// multipolygon, and `contains` of each polygon prepared, found by a tree of boxes.
//
// The functions are looked up in the library that is named, so that the newest GEOS can be measured, of which a system
// may have no headers (that within the wheel of shapely: bench/peers/install).
#include <dlfcn.h>

#include <stdexcept>

#include "locate/contestant.h"
#include "locate/with_boost.h"

namespace oblast::bench {
namespace {

struct Geometry;
struct PreparedGeometry;
struct Sequence;
struct Context;

/// As geos_c.h declares them.
struct Functions {
  Context* (*init)();
  const char* (*version)();
  Sequence* (*create_sequence)(Context*, unsigned, unsigned);
  int (*set_xy)(Context*, Sequence*, unsigned, double, double);
  Geometry* (*create_ring)(Context*, Sequence*);
  Geometry* (*create_polygon)(Context*, Geometry*, Geometry**, unsigned);
  Geometry* (*create_collection)(Context*, int, Geometry**, unsigned);
  const PreparedGeometry* (*prepare)(Context*, const Geometry*);
  char (*contains)(Context*, const PreparedGeometry*, double, double);
  char (*intersects)(Context*, const PreparedGeometry*, double, double);
  Context* context;

  explicit Functions(const std::string& file) {
    void* const library = dlopen(file.c_str(), RTLD_NOW);
    if (library == nullptr) throw std::runtime_error(dlerror());
    const auto find = [&](auto& function, const char* name) {
      void* const found = dlsym(library, name);
      if (found == nullptr) throw std::runtime_error(file + " has no " + name);
      function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(found);
    };
    find(init, "GEOS_init_r");
    find(version, "GEOSversion");
    find(create_sequence, "GEOSCoordSeq_create_r");
    find(set_xy, "GEOSCoordSeq_setXY_r");
    find(create_ring, "GEOSGeom_createLinearRing_r");
    find(create_polygon, "GEOSGeom_createPolygon_r");
    find(create_collection, "GEOSGeom_createCollection_r");
    find(prepare, "GEOSPrepare_r");
    find(contains, "GEOSPreparedContainsXY_r");
    find(intersects, "GEOSPreparedIntersectsXY_r");
    context = init();
  }

  Geometry* ring(std::span<const Point> contour) const {
    const auto count = static_cast<unsigned>(contour.size());
    Sequence* const sequence = create_sequence(context, count + 1, 2);
    for (unsigned i = 0; i <= count; ++i) set_xy(context, sequence, i, contour[i % count].x, contour[i % count].y);
    return create_ring(context, sequence);
  }
  std::vector<Geometry*> polygons(const RegionView& regions) const {
    std::vector<Geometry*> result;
    for (std::size_t p = 0; p < regions.polygon_count(); ++p) {
      std::vector<Geometry*> rings;
      for (std::uint32_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c)
        rings.push_back(ring(regions.contour(c)));
      result.push_back(create_polygon(context, rings[0], rings.data() + 1, static_cast<unsigned>(rings.size() - 1)));
    }
    return result;
  }
};

// Geometries live as long as the program: each contestant is loaded a few times at most.

class WithGeos : public Contestant {
 public:
  WithGeos(const Functions& geos, bool with_boundary) : geos_(geos), with_boundary_(with_boundary) {}

  std::string name() const override {
    return std::string("GEOS ") + geos_.version() + (with_boundary_ ? ", intersects" : ", contains");
  }
  std::string library() const override { return "GEOS"; }
  bool with_boundary() const override { return with_boundary_; }
  void load(const RegionView& regions) override {
    std::vector<Geometry*> polygons = geos_.polygons(regions);
    constexpr int multipolygon = 6;
    geometry_ =
        geos_.create_collection(geos_.context, multipolygon, polygons.data(), static_cast<unsigned>(polygons.size()));
    first_ = regions.points.front();
  }
  void build() override {
    prepared_ = geos_.prepare(geos_.context, geometry_);
    // The index is made at the second question (for one only it would not pay).
    std::uint8_t answer = 0;
    for (int i = 0; i < 3; ++i) ask({&first_, 1}, {&answer, 1});
  }
  void ask(std::span<const Point> points, std::span<std::uint8_t> inside) override {
    const auto asked = with_boundary_ ? geos_.intersects : geos_.contains;
    for (std::size_t i = 0; i < points.size(); ++i)
      inside[i] = asked(geos_.context, prepared_, points[i].x, points[i].y) == 1;
  }

 private:
  const Functions& geos_;
  bool with_boundary_;
  Geometry* geometry_ = nullptr;
  const PreparedGeometry* prepared_ = nullptr;
  Point first_{};
};

class WithGeosByPolygon : public Contestant {
 public:
  explicit WithGeosByPolygon(const Functions& geos) : geos_(geos) {}

  std::string name() const override { return std::string("GEOS ") + geos_.version() + ", rtree of polygons, contains"; }
  std::string library() const override { return "GEOS"; }
  void load(const RegionView& regions) override {
    geometries_ = geos_.polygons(regions);
    polygons_ = boost_polygons(regions);
  }
  void build() override {
    tree_ = tree_of(polygons_);
    prepared_.clear();
    for (std::size_t p = 0; p < polygons_.size(); ++p) {
      prepared_.push_back(geos_.prepare(geos_.context, geometries_[p]));
      const BoostPoint& v = polygons_[p].outer().front();
      for (int i = 0; i < 3; ++i) (void)geos_.contains(geos_.context, prepared_.back(), v.x(), v.y());
    }
  }
  void ask(std::span<const Point> points, std::span<std::uint8_t> inside) override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point& p = points[i];
      inside[i] = is_in_any(tree_, {p.x, p.y}, [&](std::uint32_t polygon) {
        return geos_.contains(geos_.context, prepared_[polygon], p.x, p.y) == 1;
      });
    }
  }

 private:
  const Functions& geos_;
  std::vector<Geometry*> geometries_;
  std::vector<BoostPolygon> polygons_;
  std::vector<const PreparedGeometry*> prepared_;
  PolygonTree tree_;
};

}  // namespace

std::vector<std::unique_ptr<Contestant>> geos_contestants(const std::string& library_file) {
  static const Functions geos(library_file);
  std::vector<std::unique_ptr<Contestant>> result;
  result.push_back(std::make_unique<WithGeos>(geos, false));
  result.push_back(std::make_unique<WithGeos>(geos, true));
  result.push_back(std::make_unique<WithGeosByPolygon>(geos));
  return result;
}

}  // namespace oblast::bench
