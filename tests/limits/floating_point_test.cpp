// In any floating-point environment of the caller, every public function gives the same bytes, and restores the
// environment: on the caller's thread, on other threads that work for it, and if it throws.
#include "base/floating_point.h"

#include <gtest/gtest.h>
#include <oblast/overlay.h>
#include <tbb/task_scheduler_observer.h>

#include <cmath>
#include <limits>
#include <set>

#include "generators/hostile.h"
#include "support/floating_point_modes.h"
#include "support/public_functions.h"

namespace oblast::testing {
namespace {

/// A polygon of `n` corners about the box of the regions.
RegionSet convex_around(const RegionSet& regions, int n) {
  double size = 0;
  for (const Point& p : regions.points) size = std::max({size, std::fabs(p.x), std::fabs(p.y)});
  RegionSet result;
  for (int i = 0; i < n; ++i)
    result.points.push_back({size * 0.6 * std::cos(i * 6.28 / n), size * 0.6 * std::sin(i * 6.28 / n)});
  result.contour_ends = {static_cast<std::uint32_t>(n)};
  result.polygon_ends = {1};
  return result;
}

void expect_the_same_in_all_modes(const generators::Operands& operands, const char* what, const CallOptions& options) {
  const RegionSet convex = convex_around(operands.a, 9);
  for (const PublicFunction& function : public_functions(operands.a, operands.b, convex)) {
    const Bits expected = function.call(options);
    for (const Modes& modes : all_modes) {
      std::uint64_t before, after;
      Bits found;
      {
        const WithModes with(modes);
        before = processor_modes();
        found = function.call(options);
        after = processor_modes();
      }
      EXPECT_EQ(found, expected) << function.name << " of " << what << ", " << modes.name;
      EXPECT_EQ(after, before) << function.name << " of " << what << ", " << modes.name;
    }
  }
}

TEST(FloatingPoint, noModeChangesABitOfAnyFunction) {
  CallOptions options;
  options.threads = 1;
  for (const auto& generator : generators::hostile_generators())
    for (const std::uint64_t seed : {1, 2})
      expect_the_same_in_all_modes(generator.make(seed, generator.usual), generator.name, options);
}

TEST(FloatingPoint, noModeChangesABitOnSeveralThreads) {
  CallOptions options;
  options.threads = 2;
  expect_the_same_in_all_modes(generators::coverages(4, 20000), "a coverage", options);
  expect_the_same_in_all_modes(generators::earth_degrees(4, 6000), "rotated pixels", options);
}

/// Threads of the pool begin with modes that other code has left there.
class ModesOfThePool : public tbb::task_scheduler_observer {
 public:
  explicit ModesOfThePool(const Modes& modes) : modes_(modes) { observe(true); }
  ~ModesOfThePool() override { observe(false); }
  void on_scheduler_entry(bool) override { set_modes(modes_); }
  void on_scheduler_exit(bool) override { set_modes(usual_modes); }

 private:
  Modes modes_;
};

TEST(FloatingPoint, modesThatAThreadOfThePoolHasMakeNoDifference) {
  const generators::Operands operands = generators::coverages(4, 20000);
  const RegionSet expected = overlay(operands.a, operands.b, Operation::symmetric_difference);
  for (const Modes& modes : all_modes) {
    const ModesOfThePool pool(modes);
    EXPECT_EQ(overlay(operands.a, operands.b, Operation::symmetric_difference), expected) << modes.name;
  }
  set_modes(usual_modes);
}

TEST(FloatingPoint, flagsAndModesAreAsBeforeWhereACallThrows) {
  RegionSet bad = generators::stars(1, 300).a;
  bad.points.back().x = std::numeric_limits<double>::quiet_NaN();
  const WithModes with(all_modes.back());
  std::feclearexcept(FE_ALL_EXCEPT);
  EXPECT_THROW(unite(bad), Error);
  EXPECT_EQ(std::fetestexcept(FE_ALL_EXCEPT), 0);
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
  const RegionSet good = generators::stars(1, 300).a;
  std::feclearexcept(FE_ALL_EXCEPT);
  unite(good);
  EXPECT_EQ(std::fetestexcept(FE_ALL_EXCEPT), 0);
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
}

TEST(FloatingPoint, theCallersFunctionRunsInTheCallersModes) {
  const generators::Operands operands = generators::coverages(4, 20000);
  for (const int threads : {1, 2}) {
    for (const Modes& modes : all_modes) {
      std::set<std::uint64_t> seen;
      std::uint64_t callers;
      Options options;
      options.threads = threads;
      options.progress = [&](Stage, double) {
        seen.insert(processor_modes());  // one at a time
        return true;
      };
      {
        const WithModes with(modes);
        callers = processor_modes();
        overlay(operands.a, operands.b, Operation::unite, options);
      }
      EXPECT_EQ(seen, std::set{callers}) << modes.name << ", " << threads << " threads";
    }
  }
}

// A call from the callback, whose modes are not the default, is protected, too.
TEST(FloatingPoint, aCallFromTheCallersFunctionIsRight) {
  const generators::Operands operands = generators::coverages(4, 20000);
  const generators::Operands inner = generators::stars(3, 60);
  const RegionSet expected = overlay(inner.a, inner.b, Operation::symmetric_difference);
  Options options;
  options.progress = [&](Stage, double) {
    EXPECT_EQ(overlay(inner.a, inner.b, Operation::symmetric_difference), expected);
    return true;
  };
  const WithModes with(all_modes.back());
  unite(operands.a, options);
}

}  // namespace
}  // namespace oblast::testing
