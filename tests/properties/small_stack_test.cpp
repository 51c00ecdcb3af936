// No recursion has a depth that grows with the data: every engine runs a million vertices on a stack of 256 KiB.
#include <gtest/gtest.h>
#include <oblast/oblast.h>
#include <pthread.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "support/sanitizers.h"

namespace oblast::internal {
namespace {

constexpr std::size_t stack_bytes = (testing::under_sanitizer ? 4096 : 256) * 1024;

void run_on_small_stack(const std::function<void()>& work) {
  pthread_attr_t attributes;
  ASSERT_EQ(pthread_attr_init(&attributes), 0);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, stack_bytes), 0);
  const auto call = [](void* function) -> void* {
    (*static_cast<const std::function<void()>*>(function))();
    return nullptr;
  };
  pthread_t thread{};
  std::function<void()> copy = work;
  ASSERT_EQ(pthread_create(&thread, &attributes, call, &copy), 0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
}

void add(RegionSet& s, const std::vector<Point>& ring) {
  s.points.insert(s.points.end(), ring.begin(), ring.end());
  s.contour_ends.push_back(static_cast<std::uint32_t>(s.points.size()));
  s.polygon_ends.push_back(static_cast<std::uint32_t>(s.contour_ends.size()));
}

RegionSet star(std::size_t n, double turn) {
  std::vector<Point> ring;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    const double radius = 1000 * (1 + 0.2 * std::sin(5 * (angle + turn)));
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  RegionSet s;
  add(s, ring);
  return s;
}

/// A band wound up: out along one side and back along the other.
RegionSet spiral(std::size_t n) {
  std::vector<Point> ring;
  const std::size_t half = n / 2;
  for (std::size_t k = 0; k < n; ++k) {
    const bool outward = k < half;
    const auto i = static_cast<double>(outward ? k : n - 1 - k);
    const double angle = i * 0.01, radius = 1 + angle + (outward ? 0 : 2);
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  RegionSet s;
  add(s, ring);
  return s;
}

/// Every other square is a hole: the deepest possible nesting.
RegionSet nested_squares(std::size_t n) {
  RegionSet s;
  for (std::size_t i = n; i > 0; --i) {
    const auto r = static_cast<double>(i);
    add(s, {{-r, -r}, {r, -r}, {r, r}, {-r, r}});
  }
  return s;
}

class SmallStack : public ::testing::TestWithParam<Engine> {};

TEST_P(SmallStack, holdsAMillionVertices) {
  Options options;
  options.engine = GetParam();
  options.threads = 1;  // in the calling thread
  RegionSet a = star(500000, 0), b = star(500000, 0.3), nested = nested_squares(250000), wound = spiral(1000000);
  run_on_small_stack([&] {
    EXPECT_EQ(overlay(a, b, Operation::intersection, options).polygon_ends.size(), 1U);
    EXPECT_EQ(overlay(a, b, Operation::symmetric_difference, options).polygon_ends.size(), 10U);
    EXPECT_EQ(unite(wound, options).contour_ends.size(), 1U);
    Options parity = options;
    parity.fill_a = FillRule::even_odd();
    EXPECT_EQ(unite(nested, parity).polygon_ends.size(), 125000U);
  });
}

std::string engine_name(const ::testing::TestParamInfo<Engine>& engine) {
  switch (engine.param) {
    case Engine::vatti:
      return "vatti";
    case Engine::skvortsov:
      return "skvortsov";
    default:
      return "leonov_nikitin";
  }
}

constexpr Engine engines[] = {Engine::leonov_nikitin, Engine::vatti, Engine::skvortsov};
INSTANTIATE_TEST_SUITE_P(Engines, SmallStack, ::testing::ValuesIn(engines), engine_name);

}  // namespace
}  // namespace oblast::internal
