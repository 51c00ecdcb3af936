// Memory of a call: arrays do not share it, use it again, and go elsewhere when it is used up.
#include "base/call_memory.h"

#include <gtest/gtest.h>
#include <oblast/oblast.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "base/tuning.h"
#include "generators/random.h"

namespace oblast::internal {
namespace {

using generators::Random;

/// A small call with its memory.
struct SmallCall {
  SmallCall() { call.memory = &memory; }

  CallMemory memory;
  Call call;
  WorkingFor working{call};
};

TEST(CallMemory, arraysKeepWhatIsTheirs) {
  Random random(1);
  const SmallCall small;
  Array<Array<std::uint32_t>> arrays(40);
  Array<std::uint32_t> first(arrays.size(), 0);
  for (std::uint32_t round = 0; round < 4000; ++round) {
    const auto i = static_cast<std::size_t>(random.below(40));
    arrays[i] = {};
    arrays[i].resize(static_cast<std::size_t>(random.below(round % 100 == 0 ? 20000 : 200)));
    first[i] = round * 1000;
    std::iota(arrays[i].begin(), arrays[i].end(), first[i]);
    for (std::size_t k = 0; k < arrays.size(); ++k)
      for (std::uint32_t j = 0; j < arrays[k].size(); ++j) ASSERT_EQ(arrays[k][j], first[k] + j);
  }
}

TEST(CallMemory, whatIsFreedIsTakenAgain) {
  if (sanitized) GTEST_SKIP() << "every array is the system's";
  const SmallCall small;
  const Array<int> other(10);
  const int* place = nullptr;
  for (int i = 0; i < 100000; ++i) {
    const Array<int> array(30);
    ASSERT_TRUE(!place || array.data() == place);
    place = array.data();
  }
}

TEST(CallMemory, usedUpOrTooSmallItSaysSo) {
  if (sanitized) GTEST_SKIP() << "every array is the system's";
  CallMemory memory;
  // The largest of its sizes; the smallest is 32 bytes.
  constexpr std::size_t largest = std::size_t{32} << (tuning::call_memory_sizes - 1);
  EXPECT_EQ(memory.take(largest + 1), nullptr);
  EXPECT_NE(memory.take(1), nullptr);
  std::size_t taken = 0;
  while (memory.take(largest)) ++taken;
  EXPECT_EQ(taken, (tuning::call_memory_bytes - 32) / largest);
  const std::size_t left = (tuning::call_memory_bytes - 32) % largest;
  EXPECT_EQ(memory.take(1) != nullptr, left >= 32) << "a smaller one still fits";
}

TEST(CallMemory, whatIsNotFromItGoesWhereItIsFrom) {
  Array<int> before(100, 1);
  {
    const SmallCall small;
    before = Array<int>(1 << 20, 2);
    before = Array<int>(100, 3);
    EXPECT_EQ(std::accumulate(before.begin(), before.end(), 0), 300);
    before = {};
    before.shrink_to_fit();
  }
  before.assign(100, 4);
  EXPECT_EQ(before.back(), 4);
}

TEST(CallMemory, belongsToTheInnermostCall) {
  EXPECT_EQ(CallMemory::current(), nullptr);
  {
    const SmallCall outer;
    EXPECT_EQ(CallMemory::current(), &outer.memory);
    {
      const SmallCall inner;
      EXPECT_EQ(CallMemory::current(), &inner.memory);
      Call large;
      const WorkingFor working(large);
      EXPECT_EQ(CallMemory::current(), nullptr);
    }
    EXPECT_EQ(CallMemory::current(), &outer.memory);
  }
  EXPECT_EQ(CallMemory::current(), nullptr);
}

TEST(CallMemory, aCallMayMakeOthersFromItsProgress) {
  const auto box = [](double x0, double y0, double x1, double y1) {
    return RegionSet{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {4}, {1}};
  };
  RegionSet many;
  for (int i = 0; i < 400; ++i) {
    const RegionSet one = box(i, i % 7, i + 1.5, i % 7 + 3);
    many.points.insert(many.points.end(), one.points.begin(), one.points.end());
    many.contour_ends.push_back(static_cast<std::uint32_t>(many.points.size()));
    many.polygon_ends.push_back(static_cast<std::uint32_t>(many.contour_ends.size()));
  }
  const RegionSet a = box(0, 0, 4, 4), b = box(1, 1, 5, 6), expected = overlay(a, b, Operation::unite);
  const RegionSet expected_of_many = unite(many);
  int asked = 0;
  Options options;
  options.progress = [&](Stage, double) {
    ++asked;
    EXPECT_EQ(overlay(b, a, Operation::unite), expected);
    EXPECT_EQ(unite(many), expected_of_many);
    return true;
  };
  EXPECT_EQ(overlay(a, b, Operation::unite, options), expected);
  EXPECT_GT(asked, 0);
}

}  // namespace
}  // namespace oblast::internal
