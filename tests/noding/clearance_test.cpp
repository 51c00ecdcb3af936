// What one round with a clearance does not flag, a second look at everything does not find.
#include "noding/clearance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "generators/random.h"
#include "noding/insert_cuts.h"
#include "noding/meetings.h"
#include "support/strands_of.h"
#include "support/usual_tuning.h"

namespace oblast::internal::noding {
namespace {

using generators::Random;
using testing::strands_of;

struct Looked {
  std::size_t cuts = 0;   ///< in the first round
  std::size_t near = 0;   ///< edges flagged
  std::size_t later = 0;  ///< cuts that a look at everything finds afterwards
  bool missed = false;    ///< one of them between pieces of edges that were not flagged
};

/// One round with a clearance; then every pair of pieces.
Looked look(Strands strands) {
  Looked looked;
  strands.flags.assign(strands.points.size(), 0);
  for (std::size_t s = 0; s < strands.size(); ++s)
    strands.flags[strands.begin(s)] = strands.flags[strands.ends[s] - 1] = closed_flag;
  Clearance clearance(strands);
  const auto cuts = find_meetings(strands, Grouping::none, {}, {}, &clearance);
  looked.cuts = cuts.size();
  for (const std::uint8_t f : strands.flags) looked.near += (f & near_flag) != 0;
  Strands pieces = strands;
  insert_cuts(pieces, cuts);
  Strands all = pieces;
  looked.later = find_meetings(all, Grouping::none, {}).size();
  Strands flagged = pieces;
  const auto found = find_meetings(flagged, Grouping::by_moved, {}).size();
  looked.missed = found != looked.later;
  return looked;
}

/// Triangles with coordinates origin + k * step, k below `steps`: the coarser, the more comes near or coincides.
Strands triangles(Random& random, int count, double origin, double step, int steps) {
  std::vector<std::vector<Point>> rings;
  for (int i = 0; i < count; ++i) {
    std::vector<Point> ring;
    for (int k = 0; k < 3; ++k)
      ring.push_back({origin + step * random.below(steps), origin + step * random.below(steps)});
    if (ring[0] == ring[1] || ring[1] == ring[2] || ring[2] == ring[0]) continue;
    ring.push_back(ring[0]);
    rings.push_back(ring);
  }
  return strands_of(rings);
}

TEST(Clearance, whatItLeavesOutMeetsNothing) {
  std::size_t cuts = 0, later = 0, cases = 0, clear = 0;
  for (int exponent = 3; exponent <= 30; ++exponent) {
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
      Random random(seed * 64 + static_cast<std::uint64_t>(exponent));
      // The step is a few ulps of the origin where the exponent is small, so that nothing is clear; then ever more is.
      const double step = std::ldexp(1.0, -52 + exponent / 2);
      const Looked looked = look(triangles(random, 12, 1.0, step, 1 << std::min(exponent, 28)));
      EXPECT_FALSE(looked.missed) << "exponent " << exponent << ", seed " << seed;
      cuts += looked.cuts;
      later += looked.later;
      clear += looked.near == 0 && looked.cuts > 0;
      ++cases;
    }
  }
  // The cases are of both kinds.
  EXPECT_GT(later, 100U);
  EXPECT_GT(clear, cases / (testing::usual_tuning ? 20 : 40));
}

TEST(Clearance, flagsEdgesThatComeNear) {
  const double u = 0x1p-52;
  const auto near = [](const std::vector<std::vector<Point>>& rings) { return look(strands_of(rings)).near; };
  const std::vector<Point> square{{1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}};
  EXPECT_EQ(near({square, {{1.5, 1.5}, {3, 1.25}, {3, 1.75}, {1.5, 1.5}}}), 0U);  // crosses clearly
  if (testing::usual_tuning) {
    EXPECT_EQ(near({square, {{2, 2}, {3, 2.25}, {2.25, 3}, {2, 2}}}), 0U);  // touches at a vertex
  }
  EXPECT_GT(near({square, {{2, 1.5}, {3, 1.25}, {3, 1.75}, {2, 1.5}}}), 0U);                    // a vertex on an edge
  EXPECT_GT(near({square, {{2 - 20 * u, 1.5}, {3, 1.25}, {3, 1.75}, {2 - 20 * u, 1.5}}}), 0U);  // nearly
  EXPECT_GT(near({square, {{2, 1.25}, {3, 1.25}, {3, 1.75}, {2, 1.75}, {2, 1.25}}}), 0U);       // overlaps
}

}  // namespace
}  // namespace oblast::internal::noding
