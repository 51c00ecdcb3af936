// Lee's hull against the monotone chain's, and its time a vertex.
//
//   oblast_hull_trial [POLYGONS [LARGEST [SEED]]]        defaults: 1000000 10000000 1
#include <oblast/hull.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "hull/hull_trial.h"
#include "hull/lee.h"
#include "hull/simple_polygons.h"
#include "hull/sklansky.h"
#include "noding/simple_ring.h"

namespace {

using namespace oblast;
using namespace oblast::internal;
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

/// Seconds of processor time in user mode: neither other programs nor the pages that the system hands out count.
double user_seconds() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_utime.tv_sec) + 1e-6 * static_cast<double>(used.ru_utime.tv_usec);
}

/// The least of three figures, each of runs over all rings that take 0.1 s together.
template <class Work>
double nanoseconds_a_vertex(const std::vector<std::vector<Point>>& rings, const Work& work) {
  double least = 1e300;
  for (int round = 0; round < 3; ++round) {
    const double begin = user_seconds();
    double spent = 0, vertices = 0;
    for (; spent < 0.1; spent = user_seconds() - begin)
      for (const std::vector<Point>& ring : rings) {
        work(ring);
        vertices += static_cast<double>(ring.size());
      }
    least = std::min(least, spent * 1e9 / vertices);
  }
  return least;
}

void time_a_vertex(long largest) {
  std::printf("\nuser nanoseconds a vertex %16s %16s %16s\n", "Lee's scan", "hull()", "monotone chain");
  for (const SimpleKind& kind : simple_kinds()) {
    for (long n = 1000; n <= largest; n *= 10) {
      // Of small ones many: a processor learns the branches of a few by heart.
      Random random(static_cast<std::uint64_t>(n));
      std::vector<std::vector<Point>> rings(static_cast<std::size_t>(std::max(1L, 500000 / n)));
      for (std::vector<Point>& ring : rings) ring = kind.make(random, static_cast<int>(n));
      using Ring = std::vector<Point>;
      const double lee = nanoseconds_a_vertex(rings, [](const Ring& r) { lee_hull(r, turn_at_smallest(r)); });
      const double checked = nanoseconds_a_vertex(rings, [](const Ring& r) { hull(std::span<const Point>(r)); });
      const double chain = nanoseconds_a_vertex(rings, [](const Ring& r) { chain_hull(r); });
      std::printf("%-16s %8ld %16.1f %16.1f %16.1f\n", kind.name, n, lee, checked, chain);
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
