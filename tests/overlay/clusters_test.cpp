// An overlay of many clusters far from each other, which is divided into parts, gives the bytes of the overlays of
// each cluster by itself.
#include <gtest/gtest.h>
#include <oblast/overlay.h>

#include <algorithm>
#include <atomic>

#include "collect/collect.h"
#include "collect/independent_parts.h"
#include "generators/hostile.h"
#include "generators/random.h"
#include "overlay/pipeline.h"

namespace oblast::internal {
namespace {

using Contour = std::vector<Point>;
using Polygon = std::vector<Contour>;

bool sequence_less(const Contour& p, const Contour& q) {
  return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end(), lexicographically_less);
}

std::vector<Polygon> polygons_of(const RegionView& set) {
  std::vector<Polygon> polygons(set.polygon_count());
  for (std::size_t p = 0; p < polygons.size(); ++p)
    for (std::uint32_t c = set.polygon_begin(p); c < set.polygon_end(p); ++c)
      polygons[p].emplace_back(set.contour(c).begin(), set.contour(c).end());
  return polygons;
}

void append(RegionSet& to, const RegionView& from) {
  for (const Polygon& polygon : polygons_of(from)) {
    for (const Contour& contour : polygon) {
      to.points.insert(to.points.end(), contour.begin(), contour.end());
      to.contour_ends.push_back(static_cast<std::uint32_t>(to.points.size()));
    }
    to.polygon_ends.push_back(static_cast<std::uint32_t>(to.contour_ends.size()));
  }
}

/// A few polygons in the unit square at (x, y); some clusters lack an operand.
generators::Operands cluster(generators::Random& random, double x, double y) {
  generators::Operands operands;
  const int kind = random.below(6);
  const auto add = [&](RegionSet& set) {
    for (int i = random.between(1, 3); i > 0; --i) {
      for (int k = random.between(3, 7); k > 0; --k) {
        const bool lattice = random.one_in(2);
        const auto unit = [&] { return lattice ? random.below(5) / 4.0 : random.unit(); };
        set.points.push_back({x + unit(), y + unit()});
      }
      set.contour_ends.push_back(static_cast<std::uint32_t>(set.points.size()));
      set.polygon_ends.push_back(static_cast<std::uint32_t>(set.contour_ends.size()));
    }
  };
  if (kind != 0) add(operands.a);
  if (kind != 1) add(operands.b);
  return operands;
}

TEST(Clusters, byThemselvesAndTogetherGiveTheSameBytes) {
  generators::Random random(1);
  std::vector<generators::Operands> clusters;
  generators::Operands all;
  for (int i = 0; i < 500; ++i) {
    clusters.push_back(cluster(random, 2 * (i % 23), 2 * (i / 23)));
    append(all.a, clusters.back().a);
    append(all.b, clusters.back().b);
  }
  {
    Options options;
    Control control(options);
    Statistics statistics;
    const RegionView b = all.b;
    const auto strands = collect(all.a, &b, options, resolve_by_pipeline(control), statistics.resolved_polygons);
    ASSERT_GE(independent_parts(strands, {true, true}).size(), 2u) << "the overlay is not divided";
  }
  for (const Operation operation :
       {Operation::intersection, Operation::unite, Operation::difference, Operation::symmetric_difference}) {
    for (const FillRule rule : {FillRule::polygons(), FillRule::at_least(2), FillRule::even_odd()}) {
      Options options;
      options.fill_a = rule;
      std::vector<Polygon> expected;
      for (const auto& [a, b] : clusters)
        for (Polygon& polygon : polygons_of(overlay(a, b, operation, options))) expected.push_back(std::move(polygon));
      std::sort(expected.begin(), expected.end(),
                [](const Polygon& p, const Polygon& q) { return sequence_less(p[0], q[0]); });
      EXPECT_GT(expected.size(), 100u);
      ASSERT_EQ(polygons_of(overlay(all.a, all.b, operation, options)), expected);
    }
  }
}

TEST(Clusters, aCancelledOverlayOfPartsLeavesTheNextOneAlone) {
  generators::Random random(2);
  generators::Operands all;
  for (int i = 0; i < 500; ++i) {
    const auto [a, b] = cluster(random, 2 * (i % 23), 2 * (i / 23));
    append(all.a, a);
    append(all.b, b);
  }
  const RegionSet expected = overlay(all.a, all.b, Operation::unite);
  for (int allowed = 0; allowed < 3; ++allowed) {
    Options options;
    std::atomic<int> asked = 0;
    options.progress = [&](Stage, double) { return asked++ < allowed; };
    try {
      overlay(all.a, all.b, Operation::unite, options);
      ADD_FAILURE() << "not cancelled";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::cancelled);
    }
    EXPECT_EQ(asked, allowed + 1);  // after it has returned false it is not called again
  }
  EXPECT_EQ(overlay(all.a, all.b, Operation::unite), expected);
}

}  // namespace
}  // namespace oblast::internal
