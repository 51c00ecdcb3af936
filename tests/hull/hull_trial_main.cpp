// Lee's hull against the monotone chain's, and its time a vertex.
//
//   oblast_hull_trial [POLYGONS [LARGEST [SEED]]]        defaults: 1000000 10000000 1
#include <oblast/hull.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "hull/hull_trial.h"
#include "hull/lee.h"
#include "hull/simple_polygons.h"
#include "hull/sklansky.h"

namespace {

using namespace oblast;
using namespace oblast::tests;

bool trial(long polygons, std::uint64_t seed) {
  bool good = true;
  for (const SimpleKind& kind : simple_kinds()) {
    const long count = polygons / static_cast<long>(simple_kinds().size()) + 1;
    long wrong = 0, fooled = 0, not_simple = 0, vertices = 0;
    for (long i = 0; i < count; ++i) {
      Random random(seed * 1000003 + static_cast<std::uint64_t>(i) * 8 +
                    static_cast<std::uint64_t>(&kind - &simple_kinds()[0]));
      const int n = random.one_in(10) ? random.between(50, 300) : random.between(4, 40);
      const std::vector<Point> ring = moved_about(random, kind.make(random, n));
      vertices += static_cast<long>(ring.size());
      if (i < 1000) not_simple += !is_simple(ring);
      const std::string what = compare_hulls(ring);
      if (!what.empty() && wrong++ == 0) std::printf("%s, polygon %ld: %s\n", kind.name, i, what.c_str());
      const std::vector<Point> scanned = sklansky_scan(ring);
      fooled += scanned != hull(ring);
    }
    std::printf(
        "%-16s %8ld polygons %10ld vertices  %ld wrong  %ld of the first 1000 not simple  %ld fool Sklansky's scan\n",
        kind.name, count, vertices, wrong, not_simple, fooled);
    std::fflush(stdout);
    good &= wrong == 0 && not_simple == 0;
  }
  return good;
}

void time_a_vertex(long largest) {
  std::printf("\nnanoseconds a vertex      %16s %16s %16s\n", "Lee's scan", "hull()", "monotone chain");
  for (const SimpleKind& kind : simple_kinds()) {
    for (long n = 1000; n <= largest; n *= 10) {
      Random random(static_cast<std::uint64_t>(n));
      const std::vector<Point> ring = kind.make(random, static_cast<int>(n));
      const long repeats = std::max(1L, 1000000 / n);
      const auto measure = [&](const auto& work) {
        const auto begin = std::chrono::steady_clock::now();
        for (long i = 0; i < repeats; ++i) work();
        const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - begin;
        return spent.count() / static_cast<double>(repeats) / static_cast<double>(ring.size());
      };
      const std::vector<Point> clockwise(ring.rbegin(), ring.rend());
      const double lee = measure([&] { return lee_hull(clockwise).size(); });
      const double checked = measure([&] { return hull(std::span<const Point>(ring)).size(); });
      const double chain = measure([&] {
        std::vector<Point> points = ring;
        return monotone_chain_hull(points).size();
      });
      std::printf("%-16s %8zu %16.1f %16.1f %16.1f\n", kind.name, ring.size(), lee, checked, chain);
      std::fflush(stdout);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const long polygons = argc > 1 ? std::atol(argv[1]) : 1000000, largest = argc > 2 ? std::atol(argv[2]) : 10000000;
  const bool good = trial(polygons, argc > 3 ? static_cast<std::uint64_t>(std::atol(argv[3])) : 1);
  time_a_vertex(largest);
  return good ? 0 : 1;
}
