// Monotone runs: every edge once, no run turns back, boxes from the ends, groups.
#include "noding/monotone_runs.h"

#include <gtest/gtest.h>

#include "generators/random.h"
#include "support/strands_of.h"
#include "support/usual_tuning.h"

namespace oblast::internal::noding {
namespace {

using testing::closed;
using testing::Path;
using testing::strands_of;

constexpr std::uint32_t longest = noding::longest_run;

/// A path of small steps, some of them axis-parallel.
Path random_path(generators::Random& random, int edges) {
  Path path{{0, 0}};
  while (static_cast<int>(path.size()) <= edges) {
    const Point step{static_cast<double>(random.between(-1, 3)), static_cast<double>(random.between(-1, 3))};
    if (step != Point{}) path.push_back({path.back().x + step.x, path.back().y + step.y});
  }
  return path;
}

void expect_monotone(const Strands& strands, const noding::Run& run) {
  bool right = false, left = false, up = false, down = false;
  Box box = Box::of(strands.points[run.first], strands.points[run.first]);
  for (std::uint32_t e = run.first; e < run.last; ++e) {
    const Point &p = strands.points[e], &q = strands.points[e + 1];
    right |= q.x > p.x;
    left |= q.x < p.x;
    up |= q.y > p.y;
    down |= q.y < p.y;
    box = {std::min(box.x0, q.x), std::min(box.y0, q.y), std::max(box.x1, q.x), std::max(box.y1, q.y)};
  }
  EXPECT_FALSE((right && left) || (up && down));
  EXPECT_LE(run.last - run.first, longest);
  EXPECT_EQ(run.box.x0, box.x0);
  EXPECT_EQ(run.box.y0, box.y0);
  EXPECT_EQ(run.box.x1, box.x1);
  EXPECT_EQ(run.box.y1, box.y1);
}

TEST(MonotoneRuns, coverEveryEdgeOnceAndNeverTurnBack) {
  generators::Random random(1);
  std::vector<Path> paths;
  for (int i = 0; i < 2000; ++i) paths.push_back(random_path(random, 1 + random.below(40)));
  Path straight;
  for (int i = 0; i < 40; ++i) straight.push_back({1.0 * i, 2.0 * i});
  paths.push_back(straight);
  const Strands strands = strands_of(paths);
  std::vector<int> covered(strands.points.size(), 0);
  std::uint32_t most = 0;
  for (const noding::Run& run : monotone_runs(strands, Grouping::by_strand)) {
    expect_monotone(strands, run);
    most = std::max(most, run.last - run.first);
    for (std::uint32_t e = run.first; e < run.last; ++e) ++covered[e];
  }
  EXPECT_EQ(most, longest);
  for (std::size_t s = 0; s < strands.size(); ++s)
    for (std::uint32_t v = strands.begin(s); v < strands.ends[s]; ++v)
      EXPECT_EQ(covered[v], v + 1 < strands.ends[s] ? 1 : 0);  // the last vertex of a strand starts no edge
}

TEST(MonotoneRuns, areMaximal) {
  if (!testing::usual_tuning) GTEST_SKIP() << "the longest runs are shorter";
  const Path ring = closed({{0, 0}, {1, 0}, {2, 1}, {2, 3}, {1, 4}, {0, 4}});
  const auto runs = monotone_runs(strands_of({ring}), Grouping::by_strand);
  ASSERT_EQ(runs.size(), 3u);  // right and up, left and up, straight down
  EXPECT_EQ(runs[0].last, 3u);
  EXPECT_EQ(runs[1].last, 5u);
  EXPECT_EQ(runs[2].last, 6u);
}

TEST(MonotoneRuns, sayWhereTheirStrandGetsOn) {
  // At (2, 1) on to the right, at (3, 0) back from above and from the right, at (1, -1) on downwards.
  const Strands strands = strands_of({{{0, 0}, {2, 1}, {3, 0}, {1, -1}, {2, -2}}});
  const auto runs = monotone_runs(strands, Grouping::by_strand);
  ASSERT_EQ(runs.size(), 4u);
  EXPECT_EQ(runs[0].goes_on(), 0u);  // where the strand begins
  EXPECT_EQ(runs[1].goes_on(), 1u);
  EXPECT_EQ(runs[2].goes_on(), 1u);
  EXPECT_EQ(runs[3].goes_on(), 1u);
  // Not by more than 1 on either side.
  const auto by_margin = monotone_runs(strands, Grouping::by_strand, {1, 0});
  for (const noding::Run& run : by_margin) EXPECT_EQ(run.goes_on(), 0u) << run.first;
  const auto folded = monotone_runs(strands_of({{{0, 0}, {2, 2}, {1, 1}}}), Grouping::by_strand);
  ASSERT_EQ(folded.size(), 2u);
  EXPECT_EQ(folded[1].goes_on(), 0u);
}

TEST(MonotoneRuns, takeTheGroupOfTheirStrand) {
  Strands strands = strands_of({{{0, 0}, {1, 1}}, {{2, 0}, {3, 1}}});
  strands.group = {7, 9};
  const auto runs = monotone_runs(strands, Grouping::by_strand);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].group, 7u);
  EXPECT_EQ(runs[1].group, 9u);
}

TEST(MonotoneRuns, partPiecesThatMovedFromSettledOnes) {
  Strands strands = strands_of({{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}}});
  strands.flags[1] = strands.flags[2] = moved_flag;
  const auto runs = monotone_runs(strands, Grouping::by_moved);
  ASSERT_EQ(runs.size(), 3u);
  EXPECT_EQ(runs[1].first, 1u);
  EXPECT_EQ(runs[1].last, 3u);
  EXPECT_EQ(runs[1].group, any_group);
  EXPECT_NE(runs[0].group, any_group);
  EXPECT_EQ(runs[0].group, runs[2].group);
}

}  // namespace
}  // namespace oblast::internal::noding
