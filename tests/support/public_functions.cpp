#include "support/public_functions.h"

#include <oblast/classics.h>
#include <oblast/hull.h>
#include <oblast/layers.h>
#include <oblast/oblast.h>

#include <algorithm>
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
  void add(const std::string& text) {
    bits.push_back(text.size());
    for (const char letter : text) bits.push_back(static_cast<unsigned char>(letter));
  }
  void add(std::byte b) { bits.push_back(std::to_integer<std::uint64_t>(b)); }
  void add(Location location) { bits.push_back(static_cast<std::uint64_t>(location)); }
  void add(const std::optional<Box>& box) {
    add(box.has_value());
    if (box) add(std::array{box->x0, box->y0, box->x1, box->y1});
  }
  void add(const Place& place) {
    for (const std::size_t i : {place.polygon, place.contour, place.vertex}) bits.push_back(i);
  }
  void add(const CheckReport& report) {
    add(report.is_valid());
    if (!report.fault) return;
    bits.push_back(static_cast<std::uint64_t>(report.fault->kind));
    add(report.fault->place);
    add(report.fault->other);
    add(report.fault->point);
    add(report.fault->message);
  }
  void add(const FeatureKey& key) {
    add(key.a);
    add(key.b);
  }
  void add(const FeatureSource& source) {
    add(source.layer);
    add(source.feature);
  }
  void add(const FeatureSet& features) {
    add(features.regions);
    add(features.feature_ends);
    add(features.keys);
  }
  void add(const Repaired& repaired) {
    add(repaired.features);
    for (const FeatureRepair& change : repaired.changed) {
      add(change.feature);
      for (const RepairFault fault : change.faults) add(static_cast<std::uint32_t>(fault));
      add(std::vector{change.rings_before, change.rings_after, change.rings_dropped});
      add(std::vector{change.area_removed, change.area_added, change.area_after});
    }
  }
  void add(const RepairedCoverage& repaired) {
    add(repaired.features);
    for (const CoverageRepair& change : repaired.changes) {
      add(static_cast<std::uint32_t>(change.change));
      add(change.from);
      add(change.to);
      add(change.area);
      add(change.at);
    }
    add(repaired.changed);
    bits.push_back(repaired.gaps_left);
  }
  void add(const Partition& found) {
    add(found.rows);
    add(found.source_ends);
    add(found.sources);
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

/// The points of the regions, and places between them.
std::vector<Point> queries_of(const RegionSet& regions) {
  std::vector<Point> queries = regions.points;
  for (std::size_t i = 0; i + 1 < regions.points.size(); ++i)
    queries.push_back({regions.points[i].x, regions.points[i + 1].y});
  return queries;
}

/// Those that take regions from callers who have them otherwise, or who want to know something of them.
template <class Add>
void add_others(const Add& add, const RegionSet& a, const RegionSet& b) {
  add("overlay into a result", [&](const CallOptions& call) {
    RegionSet result = b;
    overlay(a, b, Operation::symmetric_difference, with<Options>(call), result);
    return result;
  });
  add("unite into a result", [&](const CallOptions& call) {
    RegionSet result = b;
    unite(a, with<Options>(call), result);
    return result;
  });
  add("check", [&](const CallOptions& call) { return check(a, with<CheckOptions>(call)); });
  add("check a result",
      [result = unite(a)](const CallOptions& call) { return check(result, with<CheckOptions>(call)); });
  add("area", [&](const CallOptions& call) { return area(a, call); });
  add("bounds", [&](const CallOptions& call) { return bounds(a, call); });
  // Prepared now: text and bytes are the same in whatever modes they are read.
  const std::string text = to_wkt(a);
  const std::vector<std::byte> bytes = to_wkb(a);
  const std::vector<Point> queries = queries_of(a);
  add("to_wkt", [&](const CallOptions& call) { return to_wkt(a, call); });
  add("read_wkt", [text](const CallOptions& call) { return read_wkt(text, call); });
  add("to_wkb", [&](const CallOptions& call) { return to_wkb(a, call); });
  add("read_wkb", [bytes](const CallOptions& call) { return read_wkb(bytes, call); });
  add("Locator", [&, queries](const CallOptions& call) {
    const Locator locator(a, call);
    std::vector<Location> locations(queries.size());
    locator.locate(queries, locations, call);
    for (std::size_t i = 0; i < std::min<std::size_t>(queries.size(), 8); ++i)
      locations.push_back(locator.locate(queries[i]));
    return locations;
  });
  add("RegionBuilder", [&](const CallOptions&) {
    RegionBuilder builder;
    builder.add_polygon(a.points);
    builder.begin_polygon();
    for (const auto contour : b.view().contours()) builder.add_contour(contour);
    return builder.take();
  });
}

/// Those of rows; every polygon is a row.
template <class Add>
void add_rows(const Add& add, const RegionSet& a, const RegionSet& b) {
  for (const FeatureOperation operation :
       {FeatureOperation::intersection, FeatureOperation::identity, FeatureOperation::unite,
        FeatureOperation::difference, FeatureOperation::symmetric_difference})
    add("overlay_features", [&, operation](const CallOptions& call) {
      return overlay_features({a, {}}, {b, {}}, operation, with<Options>(call));
    });
  std::vector<std::uint32_t> groups(a.view().polygon_count());
  for (std::size_t i = 0; i < groups.size(); ++i) groups[i] = static_cast<std::uint32_t>(i % 3);
  add("dissolve", [&, groups](const CallOptions& call) { return dissolve({a, {}}, groups, with<Options>(call)); });
  add("depth", [&](const CallOptions& call) { return depth({a, {}}, {}, with<Options>(call)); });
  add("group_rings", [&, groups](const CallOptions& call) {
    std::vector<std::uint32_t> all(groups.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint32_t>(i);
    return group_rings({a, {}}, all, call);
  });
  add("repair", [&](const CallOptions& call) { return repair({a, {}}, with<RepairOptions>(call)); });
  add("repair_coverage", [&](const CallOptions& call) {
    CoverageRepairOptions coverage = with<CoverageRepairOptions>(call);
    coverage.overlaps = OverlapRule::largest;
    coverage.gaps_below = coverage.slivers_below = 1;
    return repair_coverage({a, {}}, coverage);
  });
  add("buffer", [&](const CallOptions& call) {
    BufferOptions options = with<BufferOptions>(call);
    options.mode = BufferMode::outside;
    return buffer({a, {b.points, b.contour_ends}, std::span(b.points).first(std::min<std::size_t>(3, b.points.size()))},
                  0.37, options);
  });
  add("buffer_rows", [&, groups](const CallOptions& call) {
    return buffer_rows({{a, {}, {}}, groups, {}, {}}, std::array{0.25, -0.125, 1.5}, with<BufferOptions>(call));
  });
  add("partition", [&](const CallOptions& call) {
    const FeatureView layers[] = {{a, {}}, {b, {}}};
    return partition(layers, with<Options>(call));
  });
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
  add_others(add, a, b);
  add_rows(add, a, b);
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
