// Clipper2, with 64-bit integers. Coordinates that are not integers are scaled by a power of two, so the largest has 48
// bits; this is not timed. As `clipper2` it returns polygons with their holes (PolyTree64), as every other engine does.
// As `clipper2-paths` it returns separate contours, which is less work.
#include <clipper2/clipper.h>

#include <cmath>

#include "driver/driver.h"

namespace {

using namespace oblast;
namespace clipper = Clipper2Lib;

struct Clipper2 {
#ifdef OBLAST_CLIPPER2_PATHS
  static std::string name() { return "clipper2-paths"; }
#else
  static std::string name() { return "clipper2"; }
#endif
  static std::string version() { return CLIPPER2_VERSION; }

  struct Prepared {
    clipper::Paths64 a, b;
  };

  explicit Clipper2(const bench::Settings& settings) : settings_(settings) {
    if (!settings.integer) scale_ = std::exp2(47 - std::ceil(std::log2(settings.largest)));
  }

  Prepared prepare(const RegionView& a, const RegionView& b) { return {convert(a), convert(b)}; }

  void run(const Prepared& input, RegionSet& result) {
    clipper::Clipper64 engine;
    engine.AddSubject(input.a);
    engine.AddClip(input.b);
#ifdef OBLAST_CLIPPER2_PATHS
    clipper::Paths64 paths;
    engine.Execute(type(), rule(), paths);
    for (const clipper::Path64& path : paths) extract_path(path, result);
#else
    clipper::PolyTree64 tree;
    engine.Execute(type(), rule(), tree);
    extract(tree, result);
#endif
  }

 private:
  clipper::ClipType type() const {
    switch (settings_.operation) {
      case Operation::intersection:
        return clipper::ClipType::Intersection;
      case Operation::unite:
        return clipper::ClipType::Union;
      case Operation::difference:
        return clipper::ClipType::Difference;
      case Operation::symmetric_difference:
        return clipper::ClipType::Xor;
    }
    return clipper::ClipType::NoClip;
  }

  clipper::FillRule rule() const {
    return settings_.fill == FillRule::Kind::even_odd ? clipper::FillRule::EvenOdd : clipper::FillRule::NonZero;
  }

  clipper::Paths64 convert(const RegionView& regions) const {
    clipper::Paths64 paths(regions.contour_count());
    for (std::size_t c = 0; c < paths.size(); ++c) {
      for (const Point& p : regions.contour(c)) {
        paths[c].emplace_back(std::llround(p.x * scale_), std::llround(p.y * scale_));
      }
    }
    return paths;
  }

  void extract_path(const clipper::Path64& path, RegionSet& result) const {
    for (const clipper::Point64& p : path) {
      result.points.push_back({static_cast<double>(p.x) / scale_, static_cast<double>(p.y) / scale_});
    }
    result.contour_ends.push_back(static_cast<std::uint32_t>(result.points.size()));
  }

  // Outer contours and holes alternate by level. Nesting can be deep, so there is no recursion.
  void extract(const clipper::PolyTree64& tree, RegionSet& result) const {
    std::vector<const clipper::PolyPath64*> outers;
    for (const auto& outer : tree) outers.push_back(outer.get());
    while (!outers.empty()) {
      const clipper::PolyPath64* outer = outers.back();
      outers.pop_back();
      extract_path(outer->Polygon(), result);
      for (const auto& hole : *outer) {
        extract_path(hole->Polygon(), result);
        for (const auto& inside : *hole) outers.push_back(inside.get());
      }
      result.polygon_ends.push_back(static_cast<std::uint32_t>(result.contour_ends.size()));
    }
  }

  bench::Settings settings_;
  double scale_ = 1;
};

}  // namespace

int main(int argc, char** argv) { return bench::drive<Clipper2>(argc, argv); }
