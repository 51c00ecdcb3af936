// Stage 2 with contours that are only assumed to be simple: those that are not are found and resolved.
#include "noding/node_strands.h"

#include <gtest/gtest.h>
#include <oblast/overlay.h>

#include <cmath>

#include "collect/collect.h"
#include "overlay/pipeline.h"
#include "verify/text_regions.h"

namespace oblast::internal {
namespace {

using noding::Strands;
using verify::regions_of;

struct Noded {
  Strands strands;
  std::uint64_t resolved = 0;
  double area = 0;  ///< winding number by winding number
};

Noded noded(const std::string& polygons) {
  const RegionSet set = regions_of(polygons);
  const Options options;
  Control control(options);
  Statistics statistics;
  noding::NodingReport report;
  Noded n;
  n.strands = node_strands(collect(set, nullptr, options, resolve_by_pipeline(control), statistics.resolved_polygons),
                           report, resolve_by_pipeline(control), statistics.resolved_polygons);
  n.resolved = statistics.resolved_polygons;
  for (std::size_t s = 0; s < n.strands.size(); ++s)
    for (std::uint32_t e = n.strands.begin(s); e + 1 < n.strands.ends[s]; ++e) {
      const Point &p = n.strands.points[e], &q = n.strands.points[e + 1];
      n.area += n.strands.change[s].a * (p.x * q.y - q.x * p.y) / 2;
    }
  return n;
}

TEST(NodeStrands, aBowTieIsItsTwoTriangles) {
  const Noded n = noded("0 0, 2 2, 2 0, 0 2");
  EXPECT_EQ(n.resolved, 1u);
  EXPECT_EQ(n.area, 2);
}

TEST(NodeStrands, aRingThatOnlyTouchesItselfIsResolved) {
  // Two lobes that run opposite ways round their common vertex, and a vertex on an edge of the same ring.
  EXPECT_EQ(noded("0 0, 2 2, 4 4, 4 0, 2 2, 0 4").resolved, 1u);
  EXPECT_EQ(noded("0 0, 2 2, 4 4, 4 0, 2 2, 0 4").area, 8);
  EXPECT_EQ(noded("0 0, 8 0, 8 8, 4 0, 0 8").resolved, 1u);
}

TEST(NodeStrands, aRingThatFoldsBackIsResolved) {
  const Noded n = noded("0 0, 4 0, 4 4, 2 2, 4 4, 0 4");  // a spike inwards
  EXPECT_EQ(n.resolved, 1u);
  EXPECT_EQ(n.area, 16);
}

TEST(NodeStrands, crossingOthersDoesNotCount) {
  const Noded n = noded("0 0, 9 0, 9 9, 5 5, 0 9 | 4 -1, 6 -1, 6 3, 5 12, 4 3");
  EXPECT_EQ(n.resolved, 0u);
}

TEST(NodeStrands, tangledContoursWithSharedEdgesAreFoundBeforeEdgesAreMerged) {
  // Two bow-ties, one of which shares an edge with a square: the merged edge belongs to both.
  const Noded n = noded("0 0, 2 2, 2 0, 0 2 | 2 0, 4 0, 4 2, 2 2 | 0 0, 2 2, 2 0, 0 2");
  EXPECT_EQ(n.resolved, 2u);
  EXPECT_EQ(n.area, 2 + 4 + 2);
}

TEST(NodeStrands, amongManyContoursEachTangledOneIsResolved) {
  std::string polygons;
  for (int i = 0; i < 300; ++i) {
    const std::string x = std::to_string(i * 10), y = std::to_string(i * 10 + 8);
    if (i > 0) polygons += " | ";
    // A bow-tie of 32, or a trapezoid of 40.
    polygons +=
        i % 3 == 0 ? x + " 0, " + y + " 0, " + x + " 8, " + y + " 8" : x + " 0, " + y + " 0, " + y + " 2, " + x + " 8";
  }
  const Noded n = noded(polygons);
  EXPECT_EQ(n.resolved, 100u);
  EXPECT_EQ(n.area, 100 * 32 + 200 * 40);
}

TEST(NodeStrands, aRingThatTouchesItselfInTheMiddleOfAFanIsResolved) {
  // A search that cuts along edges need not visit the two lobes' edges together: edges of the fan meet both.
  for (const int slivers : {10, 500, 2000}) {
    RegionSet fan;
    for (int i = 0; i < slivers; ++i) {
      const double angle = i * 6.2831853 / slivers, next = angle + 0.3 / slivers, length = 20 + i % 7;
      fan.points.insert(fan.points.end(), {{0, 0},
                                           {length * std::cos(angle), length * std::sin(angle)},
                                           {length * std::cos(next), length * std::sin(next)}});
      fan.contour_ends.push_back(static_cast<std::uint32_t>(fan.points.size()));
    }
    // Two lobes, opposite ways round.
    const RegionSet lobes = regions_of("-12 9, 0 0, 6 -6, -8 -9, 0 0, -1 4");
    EXPECT_EQ(overlay(fan, lobes, Operation::unite), overlay(fan, unite(lobes), Operation::unite)) << slivers;
  }
}

}  // namespace
}  // namespace oblast::internal
