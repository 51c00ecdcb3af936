// What the special methods gain over `overlay` where they apply: nanoseconds a call, same results. Processor time of
// one thread; `overlay` is held to one thread where it is large enough to use more.
//
//   oblast_fast_path [SECONDS]        measuring time of each figure, default 0.3
#include <oblast/classics.h>
#include <oblast/oblast.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <numbers>

#include "classics/cases.h"
#include "classics/shapes.h"

namespace {

using namespace oblast;
using namespace oblast::tests;

double seconds = 0.3;

double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Nanoseconds a call over all pairs, again and again: processor time of this thread, so that neither other programs
/// nor idle workers count.
double measure(std::size_t pairs, const std::function<void(std::size_t)>& call) {
  const double begin = thread_seconds();
  long calls = 0;
  for (;;) {
    for (std::size_t i = 0; i < pairs; ++i) call(i);
    calls += static_cast<long>(pairs);
    const double spent = thread_seconds() - begin;
    if (spent > seconds) return spent * 1e9 / static_cast<double>(calls);
  }
}

RegionSet ellipse(Random& random, int n) {
  const double x = random.in(0, 4), y = random.in(0, 4), a = random.in(3, 6), b = random.in(3, 6);
  std::vector<Point> ring;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * std::numbers::pi * i / n;
    ring.push_back({x + a * std::cos(t), y + b * std::sin(t)});
  }
  return one_contour(ring);
}

std::vector<Point> star(Random& random, int n) {
  std::vector<double> angles(static_cast<std::size_t>(n));
  for (double& a : angles) a = random.in(0, 2 * std::numbers::pi);
  std::sort(angles.begin(), angles.end());
  std::vector<Point> ring;
  for (const double a : angles) {
    const double r = random.in(0.2, 1);
    ring.push_back({r * std::cos(a), r * std::sin(a)});
  }
  return ring;
}

void report(const char* what, int n, double general, double special) {
  std::printf("%-44s %8d %12.0f %12.0f %8.1f\n", what, n, general, special, general / special);
  std::fflush(stdout);
}

void convex_pairs(Random& random) {
  for (const int n : {4, 10, 50, 1000, 100000}) {
    std::vector<ClassicCase> cases(n > 1000 ? 2 : 64);
    for (ClassicCase& c : cases) c = {ellipse(random, n), ellipse(random, n), Operation::intersection, Spread::reals};
    long differ = 0;
    for (const ClassicCase& c : cases) differ += orourke(c.a, c.b, c.operation) != overlay(c.a, c.b, c.operation);
    if (differ) std::printf("%ld DIFFER\n", differ);
    const double general =
        measure(cases.size(), [&](std::size_t i) { overlay(cases[i].a, cases[i].b, Operation::intersection); });
    const double special =
        measure(cases.size(), [&](std::size_t i) { orourke(cases[i].a, cases[i].b, Operation::intersection); });
    report("convex with convex: O'Rourke", n, general, special);
  }
}

void windows(Random& random, bool octagon) {
  const RegionSet window_regions =
      octagon ? one_contour({{-.3, -.6}, {.3, -.6}, {.6, -.3}, {.6, .3}, {.3, .6}, {-.3, .6}, {-.6, .3}, {-.6, -.3}})
              : one_contour({{-.5, -.5}, {.5, -.5}, {.5, .5}, {-.5, .5}});
  const ClipWindow window(window_regions);
  for (const int n : {10, 50, 1000, 100000}) {
    for (const double spread : {0.0, 4.0}) {
      std::vector<RegionSet> subjects(n > 1000 ? 2 : 256);
      for (RegionSet& s : subjects) {
        std::vector<Point> ring = star(random, n);
        const double x = random.in(-spread, spread), y = random.in(-spread, spread);
        for (Point& p : ring) p = {p.x + x, p.y + y};
        s = one_contour(ring);
      }
      long differ = 0;
      for (const RegionSet& s : subjects)
        differ += window.clip(s) != overlay(s, window_regions, Operation::intersection);
      if (differ) std::printf("%ld DIFFER\n", differ);
      const double general = measure(
          subjects.size(), [&](std::size_t i) { overlay(subjects[i], window_regions, Operation::intersection); });
      const double special = measure(subjects.size(), [&](std::size_t i) { window.clip(subjects[i]); });
      char what[80];
      std::snprintf(what, sizeof what, "%s window, subjects %s", octagon ? "octagon" : "rectangle",
                    spread > 0 ? "about, many outside" : "across it");
      report(what, n, general, special);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  if (argc > 1) seconds = std::atof(argv[1]);
  Random random(1);
  std::printf("%-44s %8s %12s %12s %8s\n", "", "vertices", "overlay, ns", "special, ns", "ratio");
  convex_pairs(random);
  windows(random, false);
  windows(random, true);
}
