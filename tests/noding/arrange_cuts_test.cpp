// Cuts along edges of every direction, few and many, spread evenly or not, against sorting them one by one.
#include "noding/arrange_cuts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "generators/random.h"
#include "support/strands_of.h"

namespace oblast::internal::noding {
namespace {

using generators::Random;
using testing::strands_of;

/// Cuts of the edge (a, b), which lie on it or a little beside it, in no order and some repeatedly. With a high power
/// most are near a.
std::vector<EdgeCut> random_cuts(Random& random, std::uint32_t edge, const Point& a, const Point& b, int count,
                                 double power) {
  std::vector<EdgeCut> cuts;
  for (int i = 0; i < count; ++i) {
    if (i > 0 && random.one_in(8)) {
      EdgeCut again = cuts[static_cast<std::size_t>(random.below(i))];
      again.sine = static_cast<float>(random.unit());
      cuts.push_back(again);
      continue;
    }
    const double t = std::pow(random.unit(), power);
    const Box box = Box::of(a, b);
    cuts.push_back(
        {edge,
         static_cast<float>(random.unit()),
         {std::clamp(a.x + t * (b.x - a.x), box.x0, box.x1), std::clamp(a.y + t * (b.y - a.y), box.y0, box.y1)}});
  }
  return cuts;
}

/// By the edge, then from its first vertex on: of cuts in one place the least sine.
std::vector<EdgeCut> sorted(const Strands& strands, std::vector<EdgeCut> cuts) {
  std::stable_sort(cuts.begin(), cuts.end(), [&](const EdgeCut& p, const EdgeCut& q) {
    if (p.edge != q.edge) return p.edge < q.edge;
    const Point &a = strands.points[p.edge], &b = strands.points[p.edge + 1];
    if (p.at.x != q.at.x) return (p.at.x < q.at.x) == (a.x < b.x);
    if (p.at.y != q.at.y) return (p.at.y < q.at.y) == (a.y < b.y);
    return p.sine < q.sine;
  });
  const auto same = [](const EdgeCut& p, const EdgeCut& q) { return p.edge == q.edge && p.at == q.at; };
  cuts.erase(std::unique(cuts.begin(), cuts.end(), same), cuts.end());
  return cuts;
}

TEST(ArrangeCuts, sortsAlongEveryEdge) {
  Random random(1);
  for (const double power : {1.0, 3.0, 200.0}) {
    for (const int count : {1, 2, 24, 25, 26, 400}) {
      const double tiny = 0x1p-52;
      const Strands strands = strands_of({{{0, 0},
                                           {3, 1},
                                           {-2, 5},
                                           {-2, 9},
                                           {-2, -7},
                                           {8, -7},
                                           {-9, -7},
                                           {-9 + 16 * tiny, 4},
                                           {1, 1},
                                           {1 + tiny, 3}}});
      std::vector<EdgeCut> cuts;
      for (std::uint32_t e = 0; e + 1 < strands.points.size(); ++e) {
        const auto more = random_cuts(random, e, strands.points[e], strands.points[e + 1], count, power);
        cuts.insert(cuts.end(), more.begin(), more.end());
      }
      for (std::size_t i = cuts.size(); i > 1; --i)
        std::swap(cuts[i - 1], cuts[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
      // In blocks of any sizes, as they are found.
      std::vector<std::span<const EdgeCut>> blocks;
      for (std::size_t begin = 0, size; begin < cuts.size(); begin += size) {
        size = std::min<std::size_t>(cuts.size() - begin, 1 + static_cast<std::size_t>(random.below(100)));
        blocks.push_back(std::span(cuts).subspan(begin, size));
      }
      const LargeArray<EdgeCut> arranged = arrange_cuts(strands, blocks, {}, nullptr);
      const std::vector<EdgeCut> expected = sorted(strands, cuts);
      ASSERT_EQ(arranged.size(), expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i) {
        ASSERT_EQ(arranged[i].edge, expected[i].edge);
        ASSERT_EQ(arranged[i].at, expected[i].at) << "edge " << expected[i].edge << ", power " << power;
        ASSERT_EQ(arranged[i].sine, expected[i].sine);
      }
    }
  }
}

}  // namespace
}  // namespace oblast::internal::noding
