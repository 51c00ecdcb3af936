// Cutting: vertices where they belong, flags, origins, nothing else changed.
#include "noding/insert_cuts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "generators/random.h"
#include "support/strands_of.h"

namespace oblast::internal::noding {
namespace {

using testing::strands_of;

EdgeCut cut(std::uint32_t edge, const Point& at) {
  EdgeCut c{};
  c.edge = edge;
  c.at = at;
  return c;
}

TEST(InsertCuts, putsVerticesInTheirEdges) {
  Strands strands = strands_of({{{0, 0}, {4, 0}, {4, 4}}, {{9, 9}, {8, 8}}}, {2, -1}, 7);
  strands.flags[0] = near_flag;
  strands.flags[1] = moved_flag | node_flag;
  strands.rules = {true, false};
  const std::vector<EdgeCut> cuts = {cut(0, {1, 0}), cut(0, {3, 0}), cut(3, {8.5, 8.5})};
  Strands pieces = strands;
  insert_cuts(pieces, cuts);
  EXPECT_EQ(pieces.points, (LargeArray<Point>{{0, 0}, {1, 0}, {3, 0}, {4, 0}, {4, 4}, {9, 9}, {8.5, 8.5}, {8, 8}}));
  EXPECT_EQ(pieces.ends, (Array<std::uint32_t>{5, 8}));
  constexpr std::uint8_t added = node_flag | added_flag | moved_flag;
  // Only pieces of the cut edge that is near others count as moved; the old mark of the second edge is gone, its node
  // is not.
  constexpr std::uint8_t clear = node_flag | added_flag;
  EXPECT_EQ(pieces.flags, (Array<std::uint8_t>{moved_flag, added, added, node_flag, 0, 0, clear, 0}));
  EXPECT_EQ(pieces.origin, (Array<std::uint32_t>{0, 0, 0, 1, 2, 3, 3, 4}));
  EXPECT_EQ(pieces.change, strands.change);
  EXPECT_EQ(pieces.group, strands.group);
  EXPECT_TRUE(pieces.rules.parity_a);
}

TEST(InsertCuts, keepsTheOriginOfEarlierRounds) {
  Strands twice = strands_of({{{0, 0}, {1, 1}, {9, 1}}});
  insert_cuts(twice, std::vector<EdgeCut>{cut(1, {5, 1})});
  insert_cuts(twice, std::vector<EdgeCut>{cut(1, {3, 1}), cut(2, {7, 1})});
  EXPECT_EQ(twice.points, (LargeArray<Point>{{0, 0}, {1, 1}, {3, 1}, {5, 1}, {7, 1}, {9, 1}}));
  EXPECT_EQ(twice.origin, (Array<std::uint32_t>{0, 1, 1, 1, 1, 2}));
}

TEST(InsertCuts, inPlaceAndToNewArraysAlike) {
  generators::Random random(3);
  std::vector<testing::Path> paths;
  std::vector<EdgeCut> cuts;
  for (std::uint32_t vertex = 0; vertex < 50000;) {
    testing::Path path(static_cast<std::size_t>(random.between(2, 90)));
    for (std::size_t i = 0; i < path.size(); ++i, ++vertex) {
      path[i] = {1.0 * vertex, 0};
      const bool dense = vertex / 5000 % 2 == 0;
      for (int k = i + 1 < path.size() && random.below(dense ? 2 : 30) == 0 ? 1 + random.below(3) : 0; k > 0; --k)
        cuts.push_back(cut(vertex, {vertex + 1.0 / (1 + k), 0}));
    }
    paths.push_back(path);
  }
  Strands crowded = strands_of(paths);
  for (std::uint8_t& flags : crowded.flags) flags = static_cast<std::uint8_t>(random.below(32));
  for (std::uint32_t v = 0; v < crowded.points.size(); ++v) crowded.origin.push_back(7 * v);
  crowded.points.shrink_to_fit();
  Strands roomy = crowded;
  roomy.points.reserve(roomy.points.size() + cuts.size());
  const Point* const place = roomy.points.data();
  insert_cuts(crowded, cuts);
  insert_cuts(roomy, cuts);
  EXPECT_EQ(roomy.points.data(), place);
  EXPECT_EQ(crowded.points, roomy.points);
  EXPECT_EQ(crowded.flags, roomy.flags);
  EXPECT_EQ(crowded.origin, roomy.origin);
  EXPECT_EQ(crowded.ends, roomy.ends);
  EXPECT_TRUE(std::is_sorted(crowded.points.begin(), crowded.points.end(), lexicographically_less));
}

TEST(InsertCuts, withoutCutsChangesNoPoint) {
  const Strands strands = strands_of({{{0, 0}, {1, 1}}, {{2, 2}, {3, 3}}});
  Strands same = strands;
  insert_cuts(same, {});
  EXPECT_EQ(same.points, strands.points);
  EXPECT_EQ(same.ends, strands.ends);
}

}  // namespace
}  // namespace oblast::internal::noding
