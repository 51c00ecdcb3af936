// CallOptions::most_bytes: with any limit a call succeeds or ends with Error(memory_limit). It leaks nothing, and the
// next call is right.
#include <gtest/gtest.h>
#include <oblast/overlay.h>
#include <oblast/workspace.h>

#include <cstdio>
#include <cstring>
#include <string>

#include "base/call_memory.h"
#include "base/index_limits.h"
#include "faults/allocations.h"
#include "generators/hostile.h"
#include "support/public_functions.h"
#include "support/sanitizers.h"

namespace oblast::testing {
using namespace internal;
namespace {

/// The result of the function; nothing if it reached the limit.
Bits call_within(const PublicFunction& function, const CallOptions& options) {
  try {
    return function.call(options);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::memory_limit) << function.name << ": " << error.what();
    EXPECT_NE(std::string(error.what()).find(std::to_string(options.most_bytes)), std::string::npos) << error.what();
    return {};
  }
}

/// Begins with a limit of one byte, and increases it by its `part`-th part until the call succeeds.
void expect_limits_kept(const PublicFunction& function, CallOptions options, std::size_t part) {
  const Bits expected = function.call(options);
  function.call(options);
  int refused = 0;
  std::size_t limit = 1;
  for (bool done = false; !done; limit += limit / part + 1) {
    ASSERT_LT(limit, std::size_t{1} << 30) << function.name;
    options.most_bytes = limit;
    const std::int64_t before = live_blocks();
    Bits found = call_within(function, options);
    done = !found.empty();
    EXPECT_TRUE(!done || found == expected) << function.name << ", " << limit << " bytes";
    found = Bits();
    if (!options.workspace) {
      EXPECT_EQ(live_blocks(), before) << function.name << ", " << limit << " bytes";
    }
    refused += !done;
  }
  // A clip of what lies elsewhere needs nothing: three sizes of 0 are an empty result.
  EXPECT_TRUE(refused > 0 || expected == Bits(3, 0) || !function.returns_much())
      << function.name << " was never refused";
  // On several threads a call needs more one time than another, as they happen to run.
  options.most_bytes *= 4;
  EXPECT_EQ(call_within(function, options), expected) << function.name;
  options.most_bytes = 0;
  EXPECT_EQ(function.call(options), expected) << function.name;
}

RegionSet octagon() { return {{{10, 0}, {7, 7}, {0, 10}, {-7, 7}, {-10, 0}, {-7, -7}, {0, -10}, {7, -7}}, {8}, {1}}; }

void expect_limits_kept_by_all(const generators::Operands& operands, const CallOptions& options, std::size_t part) {
  const RegionSet convex = octagon();
  for (const PublicFunction& function : public_functions(operands.a, operands.b, convex))
    if (function.takes_options()) expect_limits_kept(function, options, part);
}

TEST(MemoryLimit, anyLimitEndsInTheAnswerOrTheError) {
  CallOptions options;
  options.threads = 1;
  expect_limits_kept_by_all(generators::coverages(3, 400), options, 2);
  expect_limits_kept_by_all(generators::stars(3, 200), options, 1);
}

TEST(MemoryLimit, onSeveralThreadsToo) {
  CallOptions options;
  options.threads = 2;
  expect_limits_kept_by_all(generators::coverages(3, 6000), options, 1);
}

TEST(MemoryLimit, withAWorkspaceToo) {
  CallOptions options;
  options.threads = 1;
  Workspace workspace;
  options.workspace = &workspace;
  expect_limits_kept_by_all(generators::coverages(3, 3000), options, 1);
}

TEST(MemoryLimit, smallCallsNeedHardlyAny) {
  const RegionSet convex = octagon();
  for (const PublicFunction& function : public_functions(convex, convex, convex)) {
    CallOptions options;
    const Bits expected = function.call(options);
    // A Locator has thousands of cells, however few the edges are.
    options.most_bytes = function.name == "Locator" ? 512 << 10 : 64 << 10;
    Bits found;
    EXPECT_NO_THROW(found = function.call(options)) << function.name;
    EXPECT_EQ(found, expected) << function.name;
  }
}

/// Teeth with two long edges each, side by side along x, or along y if `turned`.
RegionSet comb(int teeth, bool turned) {
  RegionSet comb;
  const auto add = [&](double x, double y) { comb.points.push_back(turned ? Point{y, x} : Point{x, y}); };
  add(0, -1);
  for (int i = 0; i < teeth; ++i) {
    add(2 * i, 2.0 * teeth + 1);
    add(2 * i + 1, 1.0 / (i + 2));
  }
  add(2.0 * teeth, -1);
  comb.contour_ends = {static_cast<std::uint32_t>(comb.points.size())};
  comb.polygon_ends = {1};
  return comb;
}

/// The peak memory of this process, in bytes; 0 if the system does not report it.
std::size_t peak_bytes() {
  std::size_t kilobytes = 0;
  if (std::FILE* const file = std::fopen("/proc/self/status", "r")) {
    char line[256];
    while (std::fgets(line, sizeof line, file))
      if (std::strncmp(line, "VmHWM:", 6) == 0) std::sscanf(line + 6, "%zu", &kilobytes);
    std::fclose(file);
  }
  return kilobytes << 10;
}

// They cross a thousand million times: more than 2^31 cuts from a megabyte of input.
TEST(MemoryLimit, twoCombsOf33000EdgesEndWithinHalfAGibibyte) {
  const RegionSet a = comb(16500, false), b = comb(16500, true);
  for (const int threads : {1, 2}) {
    Options options;
    options.threads = threads;
    options.most_bytes = std::size_t{512} << 20;
    const auto expect_refused = [&] {
      try {
        overlay(a, b, Operation::unite, options);
        ADD_FAILURE() << "it was done";
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), low_index_limits ? ErrorCode::too_large : ErrorCode::memory_limit) << error.what();
      }
    };
    expect_refused();  // makes objects that the scheduler allocates only once
    const std::int64_t before = live_blocks();
    expect_refused();
    EXPECT_EQ(live_blocks(), before);
    if (!under_sanitizer) {
      EXPECT_LT(peak_bytes(), std::size_t{768} << 20);
    }
  }
}

}  // namespace
}  // namespace oblast::testing
