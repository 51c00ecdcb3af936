// Rows: small cases worked out by hand, and what must hold of all of them.
#include <gtest/gtest.h>
#include <oblast/oblast.h>

#include <algorithm>

#include "generators/random.h"
#include "verify/rows.h"

namespace oblast::internal {
namespace {

/// Squares [x, x + w] x [y, y + w].
struct Layer {
  RegionSet regions;
  std::vector<std::uint32_t> ends;

  Layer& polygon(double x, double y, double w) {
    for (const Point p : {Point{x, y}, Point{x + w, y}, Point{x + w, y + w}, Point{x, y + w}})
      regions.points.push_back(p);
    regions.contour_ends.push_back(static_cast<std::uint32_t>(regions.points.size()));
    regions.polygon_ends.push_back(static_cast<std::uint32_t>(regions.contour_ends.size()));
    return *this;
  }
  Layer& end() {
    ends.push_back(static_cast<std::uint32_t>(regions.polygon_ends.size()));
    return *this;
  }
  Layer& square(double x, double y, double w) { return polygon(x, y, w).end(); }
  operator FeatureView() const { return {regions, ends}; }
};

std::vector<double> areas(const FeatureSet& rows) {
  std::vector<double> found;
  for (std::size_t f = 0; f < rows.size(); ++f) {
    const RegionView regions = verify::regions_of(rows, f);
    found.push_back(regions.points.empty() ? 0 : signed_area(regions));
  }
  return found;
}

void expect_valid(const FeatureSet& rows) {
  const auto fault = verify::check_rows(rows);
  EXPECT_FALSE(fault) << fault->what;
}

using Keys = std::vector<FeatureKey>;
constexpr std::uint32_t none = no_feature;

TEST(OverlayFeatures, KeysOfEachOperation) {
  // Two rows of A side by side, one row of B across both and beyond.
  const Layer a = Layer().square(0, 0, 2).square(2, 0, 2), b = Layer().square(1, 0, 2).square(10, 0, 1);
  const auto run = [&](FeatureOperation operation) {
    FeatureSet rows = overlay_features(a, b, operation);
    expect_valid(rows);
    return rows;
  };
  using enum FeatureOperation;
  const FeatureSet intersection_rows = run(intersection);
  EXPECT_EQ(intersection_rows.keys, (Keys{{0, 0}, {1, 0}}));
  EXPECT_EQ(areas(intersection_rows), (std::vector<double>{2, 2}));
  const FeatureSet identity_rows = run(identity);
  EXPECT_EQ(identity_rows.keys, (Keys{{0, 0}, {0, none}, {1, 0}, {1, none}}));
  EXPECT_EQ(areas(identity_rows), (std::vector<double>{2, 2, 2, 2}));
  EXPECT_EQ(run(unite).keys, (Keys{{0, 0}, {0, none}, {1, 0}, {1, none}, {none, 1}}));
  EXPECT_EQ(run(difference).keys, (Keys{{0, none}, {1, none}}));
  EXPECT_EQ(run(symmetric_difference).keys, (Keys{{0, none}, {1, none}, {none, 1}}));
}

TEST(OverlayFeatures, RowsOfOneLayerThatOverlapStayRowsThatOverlap) {
  const Layer a = Layer().square(0, 0, 4).square(1, 1, 2).square(1, 1, 2), b = Layer().square(0, 0, 8);
  const FeatureSet rows = overlay_features(a, b, FeatureOperation::intersection);
  expect_valid(rows);
  EXPECT_EQ(rows.keys, (Keys{{0, 0}, {1, 0}, {2, 0}}));
  EXPECT_EQ(areas(rows), (std::vector<double>{16, 4, 4}));
}

TEST(OverlayFeatures, NeighboursShareTheVertexWhereABorderOfTheOtherLayerEnds) {
  // The border x = 2 of A ends on the edge y = 0 of B's row. It is a vertex of all rows there.
  const Layer a = Layer().square(0, 0, 2).square(2, 0, 2), b = Layer().square(-1, -3, 6);
  const FeatureSet rows = overlay_features(a, b, FeatureOperation::unite);
  expect_valid(rows);
  EXPECT_EQ(rows.keys, (Keys{{0, 0}, {1, 0}, {none, 0}}));
}

TEST(OverlayFeatures, AHoleOfARowIsNestedInItsOwnRow) {
  // Three rows, each inside a hole of the one before.
  Layer a;
  for (int i = 0; i < 3; ++i) {
    a.polygon(i, i, 12 - 2 * i);
    a.regions.polygon_ends.pop_back();
    a.polygon(i + 0.5, i + 0.5, 11 - 2 * i);
    a.end();
  }
  const Layer b = Layer().square(-1, -1, 20);
  const FeatureSet rows = overlay_features(a, b, FeatureOperation::unite);
  expect_valid(rows);
  EXPECT_EQ(rows.keys, (Keys{{0, 0}, {1, 0}, {2, 0}, {none, 0}}));
  EXPECT_EQ(areas(rows), (std::vector<double>{23, 19, 15, 400 - 57}));
}

TEST(OverlayFeatures, APolygonOfARowMayCoverAnotherOneOfIt) {
  Layer a;
  a.polygon(0, 0, 4).polygon(1, 1, 2).polygon(3, 3, 4).end();
  const Layer b = Layer().square(0, 0, 10);
  const FeatureSet rows = overlay_features(a, b, FeatureOperation::intersection);
  expect_valid(rows);
  EXPECT_EQ(areas(rows), (std::vector<double>{16 + 16 - 1}));
  Options twice;
  twice.fill_a = FillRule::at_least(2);
  EXPECT_EQ(areas(overlay_features(a, b, FeatureOperation::intersection, twice)), (std::vector<double>{4 + 1}));
}

TEST(OverlayFeatures, EmptyRowsGiveNoRows) {
  Layer a;
  a.end().square(0, 0, 1).end();
  const FeatureSet rows = overlay_features(a, Layer(), FeatureOperation::identity);
  EXPECT_EQ(rows.keys, (Keys{{1, none}}));
}

TEST(Dissolve, UnitesByGroupAndKeepsEmptyGroups) {
  const Layer layer = Layer().square(0, 0, 1).square(1, 0, 1).square(5, 0, 1).square(1, 0, 1);
  const std::uint32_t groups[] = {0, 0, 2, 3};
  const FeatureSet rows = dissolve(layer, groups);
  expect_valid(rows);
  EXPECT_EQ(areas(rows), (std::vector<double>{2, 0, 1, 1}));
  EXPECT_EQ(rows.keys, (Keys{{0, none}, {1, none}, {2, none}, {3, none}}));
  EXPECT_EQ(rows.regions.points.size(), 8U + 4U + 4U - 2U + 0U) << "the inner border of group 0 is gone, not its ends";
}

TEST(Depth, CountsFeaturesOrGroups) {
  const Layer layer = Layer().square(0, 0, 4).square(1, 1, 2).square(1, 1, 2).square(9, 9, 1);
  const FeatureSet rows = depth(layer);
  expect_valid(rows);
  EXPECT_EQ(rows.keys, (Keys{{1, none}, {3, none}}));
  EXPECT_EQ(areas(rows), (std::vector<double>{12 + 1, 4}));
  const std::uint32_t days[] = {0, 1, 1, 7};
  const FeatureSet by_day = depth(layer, days);
  EXPECT_EQ(by_day.keys, (Keys{{1, none}, {2, none}}));
}

TEST(PartitionOfLayers, NamesTheSourcesOfEachRow) {
  const Layer a = Layer().square(0, 0, 2), b = Layer().square(1, 0, 2), c = Layer().square(20, 0, 1).square(1, 0, 1);
  const FeatureView layers[] = {a, b, c};
  const Partition found = partition(layers);
  expect_valid(found.rows);
  ASSERT_EQ(found.rows.size(), 5U);
  using Sources = std::vector<FeatureSource>;
  const auto sources = [&](std::size_t row) {
    const auto of = found.sources_of(row);
    return Sources(of.begin(), of.end());
  };
  EXPECT_EQ(sources(0), (Sources{{0, 0}}));
  EXPECT_EQ(sources(1), (Sources{{0, 0}, {1, 0}}));
  EXPECT_EQ(sources(2), (Sources{{0, 0}, {1, 0}, {2, 1}}));
  EXPECT_EQ(sources(3), (Sources{{1, 0}}));
  EXPECT_EQ(sources(4), (Sources{{2, 0}}));
}

/// Rectangles with whole coordinates: every crossing is exact, so areas are, too.
Layer random_rectangles(std::uint64_t seed, int count) {
  generators::Random random(seed);
  Layer layer;
  for (int i = 0; i < count; ++i) {
    const double x = random.below(30), y = random.below(30), w = 1 + random.below(12), h = 1 + random.below(12);
    for (const Point p : {Point{x, y}, Point{x + w, y}, Point{x + w, y + h}, Point{x, y + h}})
      layer.regions.points.push_back(p);
    layer.regions.contour_ends.push_back(static_cast<std::uint32_t>(layer.regions.points.size()));
    layer.regions.polygon_ends.push_back(static_cast<std::uint32_t>(layer.regions.contour_ends.size()));
    layer.end();
  }
  return layer;
}

TEST(Identities, OfExactAreas) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Layer a = random_rectangles(seed, 12), b = random_rectangles(seed + 1000, 12);
    double input = 0;
    for (const PolygonView polygon : a.regions.polygons()) input += signed_area(polygon);

    const FeatureSet depths = depth(a);
    double covered = 0;
    for (std::size_t row = 0; row < depths.size(); ++row) covered += depths.keys[row].a * areas(depths)[row];
    EXPECT_EQ(covered, input) << "depth times area";

    // Each row of A is the sum of the parts that lie in no row of B, and of a partition of those that lie in some.
    const FeatureView layers[] = {a, b};
    const Partition parts = partition(layers);
    std::vector<double> of_row(12, 0.0), outside(12, 0.0);
    for (std::size_t row = 0; row < parts.rows.size(); ++row) {
      const auto sources = parts.sources_of(row);
      const bool alone = std::ranges::none_of(sources, [](const FeatureSource& s) { return s.layer == 1; });
      for (const FeatureSource& source : sources) {
        if (source.layer == 1) continue;
        of_row[source.feature] += areas(parts.rows)[row];
        if (alone) outside[source.feature] += areas(parts.rows)[row];
      }
    }
    for (std::uint32_t i = 0; i < 12; ++i) EXPECT_EQ(of_row[i], signed_area(a.regions.polygon(i))) << "parts of a row";

    const FeatureSet identity = overlay_features(a, b, FeatureOperation::identity);
    for (std::size_t row = 0; row < identity.size(); ++row)
      if (identity.keys[row].b == none) {
        EXPECT_EQ(areas(identity)[row], outside[identity.keys[row].a]) << "what is outside of B";
      }

    const std::vector<std::uint32_t> one(12, 0);
    EXPECT_EQ(dissolve(a, one).regions, unite(a.regions)) << "one group is the union";
  }
}

/// Many rows on one place: sets of hundreds of sources.
TEST(Depth, OfADeepStack) {
  Layer layer;
  for (int i = 0; i < 300; ++i) layer.square(i, 0, 300);
  const FeatureSet rows = depth(layer);
  expect_valid(rows);
  ASSERT_EQ(rows.size(), 300U);
  EXPECT_EQ(rows.keys.back(), (FeatureKey{300, none}));
  for (std::size_t row = 0; row + 1 < rows.size(); ++row) EXPECT_EQ(areas(rows)[row], 600);
}

TEST(Features, BadInputIsAnError) {
  const Layer a = Layer().square(0, 0, 1);
  const auto code_of = [](const auto& call) {
    try {
      call();
    } catch (const Error& e) {
      return e.code();
    }
    return ErrorCode::cancelled;
  };
  Layer bad = a;
  bad.ends = {2};
  EXPECT_EQ(code_of([&] { overlay_features(a, bad, FeatureOperation::unite); }), ErrorCode::bad_offsets);
  bad.ends = {0};
  EXPECT_EQ(code_of([&] { overlay_features(a, bad, FeatureOperation::unite); }), ErrorCode::bad_offsets);
  EXPECT_EQ(code_of([&] { dissolve(a, std::vector<std::uint32_t>{1, 2}); }), ErrorCode::bad_option);
  EXPECT_EQ(code_of([&] { overlay_features(a, a, FeatureOperation(9)); }), ErrorCode::bad_option);
  Options options;
  options.fill_b = FillRule::nonzero();
  EXPECT_EQ(code_of([&] { overlay_features(a, a, FeatureOperation::unite, options); }), ErrorCode::bad_option);
  options = {};
  options.engine = Engine::vatti;
  EXPECT_EQ(code_of([&] { depth(a, {}, options); }), ErrorCode::bad_option);
}

}  // namespace
}  // namespace oblast::internal
