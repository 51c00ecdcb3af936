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

TEST(Reuse, smallCallsAskForNothingWhereFewEdgesCross) {
  if (!usual_tuning || sanitized) GTEST_SKIP() << "small calls have less memory of their own, or none";
  Workspace workspace;
  Options options;
  options.workspace = &workspace;
  for (const int corners : {8, 60}) {
    for (const bool notched : {false, true}) {
      const RegionSet a = wheel(corners, 0, notched), b = wheel(corners, 0.7, notched);
      for (const Operation operation : {Operation::intersection, Operation::unite}) {
        RegionSet result;
        overlay(a, b, operation, options, result);
        const FailingAllocation counted(0);
        overlay(a, b, operation, options, result);
        // If many edges cross, the memory on the stack of the call is used up.
        const std::uint64_t most = corners == 60 && notched ? 16 : 0;
        EXPECT_LE(counted.count(), most) << corners << (notched ? " notched" : "");
      }
    }
  }
}

}  // namespace
}  // namespace oblast::testing
