#include "support/public_functions.h"

#include <oblast/classics.h>
#include <oblast/hull.h>
#include <oblast/layers.h>
#include <oblast/overlay.h>
#include <oblast/triangulate.h>

#include <bit>

namespace oblast::testing {
namespace {

class BitWriter {
 public:
  Bits bits;

  void add(double x) { bits.push_back(std::bit_cast<std::uint64_t>(x)); }
  void add(std::uint32_t i) { bits.push_back(i); }
  void add(bool b) { bits.push_back(b); }
  void add(const Point& p) {
    add(p.x);
    add(p.y);
  }
  template <class T, std::size_t n>
  void add(const std::array<T, n>& items) {
    for (const T& item : items) add(item);
  }
  template <class T>
  void add(const std::vector<T>& items) {
    bits.push_back(items.size());
    for (const T& item : items) add(item);
  }
  void add(const RegionSet& r) {
    add(r.points);
    add(r.contour_ends);
    add(r.polygon_ends);
  }
  void add(const Layers& l) {
    add(l.layer);
    add(l.count);
  }
  void add(const Triangulation& t) {
    add(t.regions);
    add(t.points);
    add(t.triangles);
    add(t.neighbours);
    add(t.is_side);
    add(t.polygon);
  }
};

template <class T>
Bits bits_of(const T& value) {
  BitWriter writer;
  writer.add(value);
  return std::move(writer.bits);
}

template <class O>
O with(const CallOptions& call) {
  O options;
  static_cast<CallOptions&>(options) = call;
  return options;
}

/// Half as far to the right as it is wide: it crosses the one that it was.
RegionSet moved(const RegionSet& regions) {
  double low = regions.points[0].x, high = low;
  for (const Point& p : regions.points) low = std::min(low, p.x), high = std::max(high, p.x);
  RegionSet result = regions;
  for (Point& p : result.points) p.x += (high - low) / 2;
  return result;
}

constexpr Operation operations[] = {Operation::intersection, Operation::unite, Operation::difference,
                                    Operation::symmetric_difference};
constexpr Engine engines[] = {Engine::leonov_nikitin, Engine::vatti, Engine::skvortsov};

}  // namespace

std::vector<PublicFunction> public_functions(const RegionSet& a, const RegionSet& b, const RegionSet& convex) {
  std::vector<PublicFunction> functions;
  const RegionSet moved_convex = moved(convex);  // now: the functions may be called in other floating-point modes
  const auto add = [&](std::string name, auto function) {
    functions.push_back({std::move(name), [function](const CallOptions& call) { return bits_of(function(call)); }});
  };
  for (const Operation operation : operations)
    for (const Engine engine : engines)
      add("overlay", [&a, &b, operation, engine](const CallOptions& call) {
        Options options = with<Options>(call);
        options.engine = engine;
        options.fill_b = FillRule::nonzero();
        return overlay(a, b, operation, options);
      });
  add("overlay with defaults",
      [&](const CallOptions& call) { return overlay(a, b, Operation::intersection, with<Options>(call)); });
  add("overlay with a window",
      [&](const CallOptions& call) { return overlay(a, convex, Operation::intersection, with<Options>(call)); });
  add("unite", [&](const CallOptions& call) { return unite(a, with<Options>(call)); });
  add("hull of regions", [&](const CallOptions& call) { return hull(RegionView(a), call); });
  add("hull of points", [&](const CallOptions& call) { return hull(std::span<const Point>(a.points), call); });
  add("layers", [&](const CallOptions& call) { return layers(a, LayerRule::interiors, call); });
  add("layers by boxes", [&](const CallOptions& call) { return layers(a, LayerRule::boxes, call); });
  add("triangulate", [&](const CallOptions& call) { return triangulate(a, with<TriangulateOptions>(call)); });
  add("triangulate a result", [&](const CallOptions& call) {
    auto options = with<TriangulateOptions>(call);
    options.input = TriangleInput::result;
    options.extent = TriangleExtent::convex_hull;
    return triangulate(convex, options);
  });
  add("signed_area", [&](const CallOptions&) { return signed_area(a); });
  add("ClipWindow", [&](const CallOptions& call) { return ClipWindow(convex, call).clip(a, nullptr, call); });
  add("sutherland_hodgman", [&convex, moved_convex](const CallOptions& call) {
    return sutherland_hodgman(moved_convex, convex, nullptr, call);
  });
  for (const ClassicMethod method :
       {ClassicMethod::orourke, ClassicMethod::weiler_atherton, ClassicMethod::margalit_knott})
    for (const Operation operation : {Operation::intersection, Operation::unite, Operation::difference})
      add("classic", [&convex, moved_convex, method, operation](const CallOptions& call) {
        return classic(method, moved_convex, convex, operation, nullptr, call);
      });
  return functions;
}

}  // namespace oblast::testing
