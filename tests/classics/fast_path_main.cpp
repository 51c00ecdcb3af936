// What the fast paths of `overlay` gain over its pipeline where they are taken, and cost where they decline:
// nanoseconds a call, same results. Processor time of one thread.
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
#include "window/fast_path.h"

namespace {

using namespace oblast;
using namespace oblast::internal;
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

/// A contour with waves large and small.
std::vector<Point> wiggly(Random& random, int n) {
  std::vector<Point> ring;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * std::numbers::pi * i / n, step = 2 * std::numbers::pi / n;
    const double r = 0.8 + 0.15 * std::sin(5 * t) + 0.03 * std::sin(50 * t) + 0.3 * step * random.in(-1, 1);
    ring.push_back({r * std::cos(t), r * std::sin(t)});
  }
  return ring;
}

/// Spikes of random length, at random angles.
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

/// If no fast path is taken, the ratio is the cost of the test.
void compare(const char* what, int n, const std::vector<ClassicCase>& cases) {
  long taken = 0, differ = 0;
  for (const ClassicCase& c : cases) {
    taken += window::fast_overlay(c.a, c.b, c.operation, {}).has_value();
    differ += overlay(c.a, c.b, c.operation) != by_pipeline(c.a, c.b, c.operation);
  }
  const double pipeline =
      measure(cases.size(), [&](std::size_t i) { by_pipeline(cases[i].a, cases[i].b, cases[i].operation); });
  const double fast =
      measure(cases.size(), [&](std::size_t i) { overlay(cases[i].a, cases[i].b, cases[i].operation); });
  std::printf("%-50s %8d %7.0f %% %12.0f %12.0f %8.2f%s\n", what, n,
              100 * static_cast<double>(taken) / static_cast<double>(cases.size()), pipeline, fast, pipeline / fast,
              differ ? " DIFFER" : "");
  std::fflush(stdout);
}

std::size_t count_for(int n) { return n > 1000 ? 2 : 64; }

void convex_pairs(Random& random) {
  constexpr std::pair<Operation, const char*> operations[] = {
      {Operation::intersection, "convex with convex: intersection"},
      {Operation::unite, "convex with convex: union"},
      {Operation::difference, "convex with convex: difference"}};
  for (const auto& [operation, what] : operations)
    for (const int n : {4, 10, 50}) {
      std::vector<ClassicCase> cases(count_for(n));
      for (ClassicCase& c : cases) c = {ellipse(random, n), ellipse(random, n), operation, Spread::reals};
      compare(what, n, cases);
    }
}

RegionSet window_of(bool octagon) {
  return octagon ? one_contour({{-.3, -.6}, {.3, -.6}, {.6, -.3}, {.6, .3}, {.3, .6}, {-.3, .6}, {-.6, .3}, {-.6, -.3}})
                 : one_contour({{-.5, -.5}, {.5, -.5}, {.5, .5}, {-.5, .5}});
}

std::vector<Point> moved(std::vector<Point> ring, double x, double y) {
  for (Point& p : ring) p = {p.x + x, p.y + y};
  return ring;
}

void windows(Random& random, bool octagon) {
  for (const int n : {10, 50, 1000, 100000}) {
    for (const double spread : {0.5, 4.0}) {
      std::vector<ClassicCase> cases(count_for(n));
      for (ClassicCase& c : cases) {
        const double x = random.in(-spread, spread), y = random.in(-spread, spread);
        c = {one_contour(moved(wiggly(random, n), x, y)), window_of(octagon), Operation::intersection, Spread::reals};
      }
      char what[80];
      std::snprintf(what, sizeof what, "%s window, polygons %s", octagon ? "octagon" : "rectangle",
                    spread > 1 ? "about it, many outside" : "across it");
      compare(what, n, cases);
    }
  }
}

/// Where it must decline: late, early, and at once.
void declined(Random& random) {
  for (const int n : {10, 1000, 100000}) {
    std::vector<ClassicCase> spikes(count_for(n)), touching(count_for(n)), stars(count_for(n));
    for (std::size_t i = 0; i < spikes.size(); ++i) {
      // A vertex on a side of the window; two that are not convex.
      touching[i] = {one_contour(wiggly(random, n)), window_of(false), Operation::intersection, Spread::reals};
      touching[i].a.points[0] = {0.5, 0.01};
      spikes[i] = {one_contour(star(random, n)), window_of(false), Operation::intersection, Spread::reals};
      stars[i] = {one_contour(wiggly(random, n)), one_contour(moved(wiggly(random, n), 0.3, 0.1)),
                  Operation::intersection, Spread::reals};
    }
    compare("declined: a vertex on the window", n, touching);
    compare("spikes side by side in the window", n, spikes);
    compare("declined: neither is convex", n, stars);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  if (argc > 1) seconds = std::atof(argv[1]);
  Random random(1);
  std::printf("%-50s %8s %9s %12s %12s %8s\n", "", "vertices", "taken", "pipeline, ns", "overlay, ns", "ratio");
  convex_pairs(random);
  windows(random, false);
  windows(random, true);
  declined(random);
}
