// Calls that write into an existing result allocate next to nothing, if they are small.
#include <gtest/gtest.h>
#include <oblast/oblast.h>

#include "base/call_memory.h"
#include "faults/allocations.h"
#include "generators/circle.h"
#include "support/usual_tuning.h"

namespace oblast::testing {
namespace {

/// If `notched`, every other corner is at half the radius.
RegionSet wheel(int corners, double x, bool notched) {
  RegionSet result;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.28 * i / corners, radius = notched && i % 2 == 1 ? 0.5 : 1;
    result.points.push_back({x + radius * generators::cosine(angle), radius * generators::sine(angle)});
  }
  result.contour_ends = {static_cast<std::uint32_t>(corners)};
  result.polygon_ends = {1};
  return result;
}

/// How many allocations the second of two equal calls makes.
std::uint64_t allocations(const RegionSet& a, const RegionSet& b, Operation operation, const Options& options) {
  RegionSet result;
  overlay(a, b, operation, options, result);
  const FailingAllocation counted(0);
  overlay(a, b, operation, options, result);
  return counted.count();
}

TEST(Reuse, smallCallsAskForNothing) {
  if (!usual_tuning || sanitized) GTEST_SKIP() << "small calls have less memory of their own, or none";
  Workspace workspace;
  Options with_workspace;
  with_workspace.workspace = &workspace;
  for (const int corners : {8, 30, 50, 60, 64}) {
    for (const bool notched : {false, true}) {
      for (const double x : {0.7, 0.1, 0.0}) {  // few crossings, many, the same wheel
        const RegionSet a = wheel(corners, 0, notched), b = wheel(corners, x, notched);
        for (const Operation operation :
             {Operation::intersection, Operation::unite, Operation::difference, Operation::symmetric_difference}) {
          EXPECT_EQ(allocations(a, b, operation, with_workspace), 0u)
              << corners << (notched ? " notched" : "") << ' ' << x;
          // Without a workspace the memory on the stack is used up if many edges cross.
          if (corners == 8) {
            EXPECT_EQ(allocations(a, b, operation, {}), 0u);
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace oblast::testing
