// A workspace: calls reuse it and give the same results; it keeps no more than its limit.
#include <gtest/gtest.h>
#include <oblast/oblast.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <utility>
#include <vector>

#include "base/call_memory.h"
#include "base/parallel.h"
#include "generators/hostile.h"

namespace oblast::internal {
namespace {

RegionSet overlay_in(Workspace* workspace, const generators::Operands& operands, int threads = 1) {
  Options options;
  options.workspace = workspace;
  options.threads = threads;
  return overlay(operands.a, operands.b, Operation::symmetric_difference, options);
}

TEST(Workspace, makesNoDifferenceToResults) {
  Workspace workspace;
  for (int size = 10; size < 40000; size *= 3) {
    const generators::Operands operands = generators::coverages(size, size);
    const RegionSet expected = overlay_in(nullptr, operands);
    for (const int threads : {1, 2})
      for (int call = 0; call < 3; ++call) ASSERT_EQ(overlay_in(&workspace, operands, threads), expected) << size;
    EXPECT_LE(workspace.kept_bytes(), Workspace::usual_bytes);
  }
}

TEST(Workspace, keepsWhatItWasToldAtMost) {
  const generators::Operands operands = generators::coverages(7, 20000);
  for (const std::size_t most : {std::size_t{0}, std::size_t{2} << 20, std::size_t{64} << 20}) {
    Workspace workspace(most);
    overlay_in(&workspace, operands);
    EXPECT_LE(workspace.kept_bytes(), most);
    EXPECT_EQ(workspace.kept_bytes() > 0, most > 0) << most;
  }
}

TEST(Workspace, isEmptiedByRequestAndByCallsItIsTooSmallFor) {
  Workspace workspace;
  overlay_in(&workspace, generators::coverages(7, 20000));
  ASSERT_GT(workspace.kept_bytes(), 0u);
  workspace.clear();
  EXPECT_EQ(workspace.kept_bytes(), 0u);
  overlay_in(&workspace, generators::coverages(7, 20000));
  ASSERT_GT(workspace.kept_bytes(), 0u);
  RegionSet many;
  for (std::uint32_t i = 0; i < 100000; ++i) {
    const double x = 3.0 * i;
    for (const Point& p : {Point{x, 0}, Point{x + 1, 0}, Point{x, 1}}) many.points.push_back(p);
    many.contour_ends.push_back(3 * i + 3);
    many.polygon_ends.push_back(i + 1);
  }
  Options options;
  options.workspace = &workspace;
  EXPECT_EQ(unite(many, options).polygon_ends.size(), 100000u);
  EXPECT_EQ(workspace.kept_bytes(), 0u);
}

TEST(Workspace, canBeMoved) {
  const generators::Operands operands = generators::coverages(7, 20000);
  Workspace first;
  const RegionSet expected = overlay_in(&first, operands);
  Workspace second = std::move(first);
  EXPECT_GT(second.kept_bytes(), 0u);
  // NOLINTBEGIN(bugprone-use-after-move,clang-analyzer-cplusplus.Move): what was moved from says that it has nothing
  EXPECT_EQ(first.kept_bytes(), 0u);
  EXPECT_EQ(overlay_in(&second, operands), expected);
  EXPECT_EQ(overlay_in(&first, operands), expected);
  // NOLINTEND(bugprone-use-after-move,clang-analyzer-cplusplus.Move)
}

TEST(Workspace, oneAThread) {
  const generators::Operands operands = generators::coverages(5, 8000);
  const RegionSet expected = overlay_in(nullptr, operands);
  tbb::parallel_for(0, 40, [&](int) {
    static thread_local Workspace workspace;
    EXPECT_EQ(overlay_in(&workspace, operands), expected);
  });
}

TEST(KeptBlocks, longArraysComeBackToTheirOwner) {
  KeptBlocks blocks(std::size_t{4} << 20);
  const void* place = nullptr;
  {
    Call call;
    call.blocks = &blocks;
    const WorkingFor working(call);
    Array<double> array(100000, 1.5);
    place = array.data();
    array = Array<double>();
    EXPECT_EQ(blocks.bytes() / 100000, 8u);
    const Array<double> again(90000, 2.5);
    EXPECT_EQ(again.data(), place);
    EXPECT_EQ(blocks.bytes(), 0u);
    const Array<double> much_shorter(9000), too_long(150000);
    EXPECT_NE(much_shorter.data(), place);
  }
  const Array<double> of_no_call(90000);
  EXPECT_NE(of_no_call.data(), place);
  EXPECT_GT(blocks.bytes(), 90000 * sizeof(double));
}

TEST(KeptBlocks, areTheSameOnAllThreadsOfACall) {
  KeptBlocks blocks(std::size_t{4} << 20);
  Call call;
  call.blocks = &blocks;
  std::atomic<int> of_others = 0;
  run_call(call, 4, [&] {
    for_ranges(400, 1, [&](std::size_t begin, std::size_t end) {
      for (; begin < end; ++begin) of_others += Call::current()->blocks != &blocks;
    });
  });
  EXPECT_EQ(of_others, 0);
}

TEST(KeptBlocks, theOldestGoFirst) {
  KeptBlocks blocks(std::size_t{1} << 20);
  Call call;
  call.blocks = &blocks;
  const WorkingFor working(call);
  for (std::size_t size = 100000; size < 900000; size += 100000) Array<char>(size, 'a');
  EXPECT_LE(blocks.bytes(), std::size_t{1} << 20);
  EXPECT_GT(blocks.bytes(), 800000u);
  const Array<char> huge(4000000);
  EXPECT_GT(blocks.bytes(), 0u);
}

}  // namespace
}  // namespace oblast::internal
