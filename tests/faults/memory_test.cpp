// Lets every single allocation of every public function fail: the call throws std::bad_alloc and leaks nothing, and the
// next call is right.
#include <gtest/gtest.h>
#include <oblast/classics.h>
#include <oblast/hull.h>
#include <oblast/layers.h>
#include <oblast/oblast.h>
#include <oblast/triangulate.h>
#include <tbb/task_arena.h>

#include "faults/every_allocation.h"
#include "faults/inputs.h"
#include "generators/hostile.h"
#include "generators/random.h"
#include "support/public_functions.h"

namespace oblast::testing {
namespace {

/// In one thread, so the same allocation fails each time.
template <typename Function>
void fail_every_allocation_of(const Function& function, std::uint64_t fewest = 5) {
  tbb::task_arena(1).execute([&] {
    const auto expected = function();
    fail_every_allocation([&] { return function() == expected; }, [] {}, fewest);
  });
}

/// A small call allocates little except its result, because its memory is on the stack (call_memory.h). A call on
/// `large_size` edges allocates all of its arrays.
constexpr int small_size = 20, large_size = 200;
constexpr std::uint64_t fewest_of_small = 1;

class OutOfMemory : public ::testing::TestWithParam<Engine> {};

TEST_P(OutOfMemory, atAnyAllocationOfAnOverlayLeavesNothingBehind) {
  Options options;
  options.engine = GetParam();
  options.threads = 1;
  for (const auto& generator : generators::hostile_generators()) {
    const generators::Operands small = generator.make(5, small_size);
    for (const Operation operation : {Operation::intersection, Operation::symmetric_difference})
      fail_every_allocation_of([&] { return overlay(small.a, small.b, operation, options); }, fewest_of_small);
  }
  const generators::Operands large = generators::coverages(3, large_size);
  fail_every_allocation_of([&] { return overlay(large.a, large.b, Operation::intersection, options); }, 50);
  // Also with a workspace, whose blocks must be back after the exception.
  Workspace workspace;
  options.workspace = &workspace;
  const generators::Operands longer = generators::coverages(3, 8 * large_size);
  const RegionSet expected = overlay(longer.a, longer.b, Operation::intersection, options);
  for (std::uint64_t number = 1; number < 40; ++number) {
    try {
      const FailingAllocation failing(number);
      EXPECT_EQ(overlay(longer.a, longer.b, Operation::intersection, options), expected);
    } catch (const std::bad_alloc&) {
    }
    EXPECT_LE(workspace.kept_bytes(), Workspace::usual_bytes);
  }
  EXPECT_EQ(overlay(longer.a, longer.b, Operation::intersection, options), expected);
}

constexpr Engine engines[] = {Engine::leonov_nikitin, Engine::vatti, Engine::skvortsov};
constexpr const char* engine_names[] = {"leonov_nikitin", "vatti", "skvortsov"};
INSTANTIATE_TEST_SUITE_P(Engines, OutOfMemory, ::testing::ValuesIn(engines),
                         [](const auto& tested) { return engine_names[static_cast<int>(tested.param)]; });

RegionSet box(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {4}, {1}};
}

/// Convex, of n vertices on a parabola from (x - 1, 1) to (x + 1, 1).
RegionSet parabola(int n, double x) {
  RegionSet result;
  for (int i = 0; i <= n; ++i) {
    const double t = 2.0 * i / n - 1;
    result.points.push_back({x + t, t * t});
  }
  result.contour_ends = {static_cast<std::uint32_t>(result.points.size())};
  result.polygon_ends = {1};
  return result;
}

TEST(OutOfMemory, atAnyAllocationOfAClassicLeavesNothingBehind) {
  const RegionSet a = box(0, 0, 4, 4), b = box(1, 1, 5, 6.3);
  const RegionSet large_a = parabola(large_size, 0), large_b = parabola(large_size, 0.25);
  for (const ClassicMethod method : {ClassicMethod::orourke, ClassicMethod::sutherland_hodgman,
                                     ClassicMethod::weiler_atherton, ClassicMethod::margalit_knott}) {
    fail_every_allocation_of([&] { return classic(method, a, b, Operation::intersection); }, fewest_of_small);
    fail_every_allocation_of([&] { return classic(method, large_a, large_b, Operation::intersection); }, 20);
  }
  fail_every_allocation_of([&] { return ClipWindow(b).clip(a); }, fewest_of_small);
  fail_every_allocation_of([&] { return ClipWindow(b).clip(large_a); }, fewest_of_small);
}

TEST(OutOfMemory, atAnyAllocationOfTheOtherFunctionsLeavesNothingBehind) {
  // In the small call most arrays are in the memory on the stack.
  for (const int size : {large_size, 8 * large_size}) {
    const RegionSet soup = generators::earth_degrees(6, size).a;
    const std::uint64_t fewest = size == large_size ? fewest_of_small : 20;
    fail_every_allocation_of([&] { return unite(soup); }, fewest);
    fail_every_allocation_of([&] { return hull(soup); }, fewest);
    fail_every_allocation_of([&] { return layers(soup); }, fewest);
    fail_every_allocation_of([&] { return triangulate(soup).triangles.size(); }, fewest);
  }
}

TEST(OutOfMemory, atAnyAllocationOfAnyPublicFunctionLeavesNothingBehind) {
  const RegionSet convex = box(-0.5, -0.5, 0.5, 0.5);
  CallOptions options;
  options.threads = 1;
  for (const int size : {small_size, large_size}) {
    const auto [a, b] = generators::coverages(6, size);
    for (const PublicFunction& function : public_functions(a, b, convex)) {
      SCOPED_TRACE(function.name);
      // What the function returned is written down in memory of its own, so there is always something that can fail.
      fail_every_allocation_of([&] { return function.call(options); }, fewest_of_small);
    }
  }
}

// Which allocation fails differs from run to run here.
TEST_P(OutOfMemory, inAnyThreadLeavesNothingBehind) {
  generators::Random random(4);
  constexpr Operation operations[] = {Operation::symmetric_difference, Operation::intersection, Operation::unite,
                                      Operation::difference};
  std::size_t next_operation = 0;
  for (const auto& [name, operands] : threshold_inputs(usual_scale)) {
    for (const int threads : {2, 8}) {
      const Operation operation = operations[next_operation++ % std::size(operations)];
      SCOPED_TRACE(name + ", operation " + std::to_string(static_cast<int>(operation)) + ", " +
                   std::to_string(threads) + " threads");
      Options options;
      options.engine = GetParam();
      options.threads = threads;
      const auto call = [&] { return overlay(operands.a, operands.b, operation, options); };
      const RegionSet expected = call();
      std::uint64_t allocations = 0;
      {
        const FailingAllocation none(std::uint64_t(-1));
        call();
        allocations = none.count();
      }
      const std::int64_t before = live_blocks();
      int thrown = 0;
      for (int trial = 0; trial < 8; ++trial) {
        // The first allocations are of other kinds than those of later loops.
        const auto number = 1 + random.next() % (trial < 3 ? std::min<std::uint64_t>(allocations, 60) : allocations);
        try {
          const FailingAllocation failing(number);
          EXPECT_EQ(call(), expected);
        } catch (const std::bad_alloc&) {
          ++thrown;
        }
      }
      EXPECT_GT(thrown, 0);
      EXPECT_EQ(call(), expected);
      EXPECT_EQ(live_blocks(), before);
    }
  }
}

}  // namespace
}  // namespace oblast::testing
