// Independent parts against brute force: boxes of strands in different batches never meet, nothing that matters is
// left out, batches have the vertices they should.
#include "collect/independent_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "base/tuning.h"
#include "generators/random.h"
#include "noding/monotone_runs.h"
#include "support/strands_of.h"

namespace oblast::internal {
namespace {

using generators::Random;
using noding::Strands;
using testing::box;
using testing::closed;
using testing::Path;
using testing::strands_of;

Box box_of(const Strands& strands, std::size_t s) {
  Box b = Box::of(strands.points[strands.begin(s)], strands.points[strands.begin(s)]);
  for (std::uint32_t v = strands.begin(s); v < strands.ends[s]; ++v) {
    const Point& p = strands.points[v];
    b = {std::min(b.x0, p.x), std::min(b.y0, p.y), std::max(b.x1, p.x), std::max(b.y1, p.y)};
  }
  return b;
}

/// Strands whose boxes meet, directly or by way of others, by brute force: by strand, the smallest of its part.
std::vector<std::uint32_t> smallest_parts(const std::vector<Box>& boxes) {
  std::vector<std::uint32_t> part(boxes.size());
  std::iota(part.begin(), part.end(), 0U);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!boxes[i].meets(boxes[j]) || part[i] == part[j]) continue;
      const std::uint32_t from = std::max(part[i], part[j]), to = std::min(part[i], part[j]);
      std::replace(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(i) + 1, from, to);
    }
  }
  return part;
}

/// Checks everything that is promised and returns the parts.
IndependentParts parts_checked(const Strands& strands, PartNeeds needs = {}) {
  IndependentParts parts = independent_parts(strands, needs);
  constexpr std::size_t left_out = 0xffffffff;
  std::vector<std::size_t> batch(strands.size(), left_out);
  for (std::size_t b = 0, i = 0; b < parts.size(); ++b) {
    std::size_t vertices = 0;
    EXPECT_LT(i, parts.ends[b]) << "an empty batch";
    for (; i < parts.ends[b]; ++i) {
      EXPECT_EQ(batch[parts.strands[i]], left_out) << "in two batches";
      batch[parts.strands[i]] = b;
      vertices += strands.ends[parts.strands[i]] - strands.begin(parts.strands[i]);
    }
    if (b + 1 < parts.size()) {
      EXPECT_GE(vertices, tuning::batch_vertices);
    }
  }
  EXPECT_EQ(parts.strands.size(), parts.ends.empty() ? 0 : parts.ends.back());

  std::vector<Box> boxes;
  for (std::size_t s = 0; s < strands.size(); ++s) boxes.push_back(box_of(strands, s));
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (batch[i] != batch[j] && boxes[i].meets(boxes[j])) ADD_FAILURE() << j << " and " << i << " were parted";

  const std::vector<std::uint32_t> smallest = smallest_parts(boxes);
  Array<noding::Winding> holds(strands.size());
  for (std::size_t s = 0; s < strands.size(); ++s) {
    holds[smallest[s]].a |= strands.change[s].a != 0;
    holds[smallest[s]].b |= strands.change[s].b != 0;
  }
  for (std::size_t s = 0; s < strands.size(); ++s) {
    const noding::Winding h = holds[smallest[s]];
    if (batch[s] == left_out) {
      EXPECT_TRUE((needs.a && h.a == 0) || (needs.b && h.b == 0)) << s << " was left out";
    }
  }
  return parts;
}

Strands scattered(int count, double size, std::uint64_t seed) {
  Random random(seed);
  std::vector<Path> paths;
  for (int i = 0; i < count; ++i) {
    const double x = random.unit(), y = random.unit();
    paths.push_back(closed(box(x, y, x + random.in(0, size), y + random.in(0, size))));
  }
  return strands_of(paths);
}

TEST(IndependentParts, ofScatteredBoxes) {
  for (const double size : {0.0, 0.005, 0.02, 0.05}) {
    const IndependentParts parts = parts_checked(scattered(2500, size, 1));
    EXPECT_EQ(parts.strands.size(), 2500u);
    if (size < 0.02) {
      EXPECT_GE(parts.size(), 2u) << size;
    }
  }
}

TEST(IndependentParts, leaveOutWhatLacksAnOperand) {
  Random random(2);
  Strands strands = scattered(2500, 0.01, 2);
  for (auto& change : strands.change) {
    change = {random.between(0, 1), random.one_in(3) ? 1 : 0};
    if (change.is_zero()) change.b = -1;
  }
  const std::size_t all = parts_checked(strands).strands.size();
  const std::size_t with_a = parts_checked(strands, {true, false}).strands.size();
  const std::size_t with_both = parts_checked(strands, {true, true}).strands.size();
  EXPECT_EQ(all, 2500u);
  EXPECT_LT(with_a, all);
  EXPECT_LT(with_both, with_a);
  EXPECT_GT(with_both, 0u);
  for (auto& change : strands.change) change = {1, 0};
  EXPECT_EQ(parts_checked(strands, {true, true}).size(), 0u);  // nothing can come of it
}

TEST(IndependentParts, boxesThatTouchAreOnePart) {
  // Side by side or corner by corner, in runs of ten; 150 of them apart from each other.
  std::vector<Path> paths;
  for (int row = 0; row < 150; ++row)
    for (int i = 0; i < 10; ++i) {
      const int at = row % 3 == 0 ? 9 - i : i;  // from either end
      const double y = 20.0 * row + (row % 2 ? at : 0);
      paths.push_back(closed(box(at, y, at + 1, y + 1)));
    }
  const Strands strands = strands_of(paths);
  const IndependentParts parts = parts_checked(strands);
  EXPECT_GE(parts.size(), 2u);
  for (const std::uint32_t end : parts.ends) EXPECT_EQ(end % 10, 0u);
}

TEST(IndependentParts, aChainIsOnePart) {
  // Each box touches the next only: the ends of the chain are connected all the same. Its order is shuffled.
  Random random(3);
  std::vector<Path> paths;
  for (int i = 0; i < 2000; ++i) paths.push_back(closed(box(i, i % 7, i + 1, i % 7 + 7)));
  for (std::size_t i = paths.size(); i > 1; --i)
    std::swap(paths[i - 1], paths[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  const IndependentParts parts = parts_checked(strands_of(paths));
  EXPECT_EQ(parts.size(), 1u);
}

TEST(IndependentParts, manyCopiesAreOnePart) {
  const Strands strands = strands_of(std::vector<Path>(10000, closed(box(0, 0, 1, 1))));
  const IndependentParts parts = independent_parts(strands, {});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts.strands.size(), 10000u);
}

TEST(IndependentParts, aBoxAroundAllIsOnePart) {
  Strands strands = scattered(2000, 0.001, 4);
  for (const Point& p : closed(box(-1, -1, 3, 3))) strands.points.push_back(p);
  strands.flags.resize(strands.points.size());
  strands.close_strand({1, 0}, noding::any_group);
  EXPECT_EQ(parts_checked(strands).size(), 1u);
}

TEST(IndependentParts, longStrandsAreBatchesOfTheirOwn) {
  // Five zigzags of 5000 vertices each, apart, and a few small boxes.
  std::vector<Path> paths;
  for (int i = 0; i < 5; ++i) {
    Path path;
    for (int k = 0; k < 5000; ++k) path.push_back({1.0 * k, 10.0 * i + k % 2});
    paths.push_back(closed(path));
    paths.push_back(closed(box(0, 10 * i + 3, 1, 10 * i + 4)));
  }
  EXPECT_GE(parts_checked(strands_of(paths)).size(), 5u);
}

TEST(IndependentParts, fewVerticesAreNotDivided) {
  constexpr auto few = static_cast<int>(tuning::batch_vertices / 5);
  const Strands strands = scattered(few, 0.001, 5);
  const IndependentParts parts = independent_parts(strands, {true, true});
  EXPECT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts.strands.size(), static_cast<std::size_t>(few));
}

TEST(IndependentParts, batchesHoldTheirStrandsUnchanged) {
  Strands strands = scattered(2500, 0.005, 6);
  for (std::size_t s = 0; s < strands.size(); ++s) {
    strands.change[s] = {static_cast<int>(s), 1};
    strands.group[s] = static_cast<noding::Group>(s % 9);
  }
  strands.rules = {true, false};
  const IndependentParts parts = independent_parts(strands, {});
  ASSERT_GE(parts.size(), 2u);
  std::size_t i = 0;
  for (std::size_t b = 0; b < parts.size(); ++b) {
    const Strands batch = batch_of(strands, parts, b);
    EXPECT_TRUE(batch.rules.parity_a && !batch.rules.parity_b);
    for (std::size_t k = 0; k < batch.size(); ++k, ++i) {
      const std::uint32_t s = parts.strands[i];
      EXPECT_EQ(batch.change[k], strands.change[s]);
      EXPECT_EQ(batch.group[k], strands.group[s]);
      ASSERT_TRUE(std::equal(batch.points.begin() + batch.begin(k), batch.points.begin() + batch.ends[k],
                             strands.points.begin() + strands.begin(s), strands.points.begin() + strands.ends[s]));
    }
  }
  EXPECT_EQ(i, strands.size());
}

TEST(IndependentParts, aBatchMovedTogetherIsTheOneCopied) {
  Strands strands = scattered(2500, 0.005, 7);
  for (std::size_t s = 0; s < strands.size(); ++s) {
    strands.change[s] = {static_cast<int>(s), 1};
    strands.group[s] = static_cast<noding::Group>(s % 9);
    if (s % 3 == 0) strands.simplicity[s] = noding::Simplicity::assumed;
  }
  strands.rules = {true, false};
  IndependentParts parts = independent_parts(strands, {});
  ASSERT_GE(parts.size(), 2u);
  for (std::size_t b = 0; b < parts.size(); ++b) {
    const Strands moved = only_batch(strands, parts, b);
    // In the order in which they stand.
    const auto first = parts.strands.begin() + (b == 0 ? 0 : parts.ends[b - 1]);
    std::sort(first, parts.strands.begin() + parts.ends[b]);
    const Strands copied = batch_of(strands, parts, b);
    EXPECT_EQ(moved.points, copied.points);
    EXPECT_EQ(moved.ends, copied.ends);
    EXPECT_EQ(moved.change, copied.change);
    EXPECT_EQ(moved.group, copied.group);
    EXPECT_EQ(moved.simplicity, copied.simplicity);
    EXPECT_TRUE(moved.rules.parity_a && !moved.rules.parity_b);
  }
}

}  // namespace
}  // namespace oblast::internal
