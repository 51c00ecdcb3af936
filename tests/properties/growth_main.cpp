// Growth on adversarial families: time and memory of a union at n, 2n, 4n and 8n edges, per (n + k) log (n + k),
// relative to the first size. Each measurement has a separate process, so its peak memory is measured separately.
//
//   oblast_growth [--edges N] [--steps S] [FAMILY...]
//
// Most families are united. For hatch and needles, A and B are intersected. Needles have far more meetings than edges,
// so for them a size counts as its square.
#include <fmt/format.h>
#include <oblast/oblast.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "generators/hostile.h"
#include "generators/random.h"

namespace {

using namespace oblast;
using generators::Operands;
using generators::Random;

void add(RegionSet& s, const std::vector<Point>& ring) {
  s.points.insert(s.points.end(), ring.begin(), ring.end());
  s.contour_ends.push_back(static_cast<std::uint32_t>(s.points.size()));
  s.polygon_ends.push_back(static_cast<std::uint32_t>(s.contour_ends.size()));
}

Point on_circle(double radius, double turns) {
  const double angle = 2 * std::numbers::pi * turns;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Thin quadrilaterals side by side, a thousand times longer than their total width.
RegionSet long_slabs(std::size_t edges) {
  const std::size_t n = edges / 4;
  RegionSet s;
  for (std::size_t i = 0; i < n; ++i) {
    const double d = 3.0 * static_cast<double>(i) / static_cast<double>(n), w = 1.0 / static_cast<double>(n);
    add(s, {{0, d}, {1000, 1000 + d}, {1000, 1000 + d + w}, {0, d + w}});
  }
  return s;
}

/// Triangles that each have an edge on the y axis, one above the other.
RegionSet one_x(std::size_t edges) {
  Random random(7);
  RegionSet s;
  for (std::size_t i = 0; i < edges / 3; ++i) {
    const auto y = static_cast<double>(i);
    add(s, {{0, y}, {random.in(1, 2), y + 0.5}, {0, y + 1}});
  }
  return s;
}

RegionSet copies(std::size_t edges) {
  RegionSet s;
  for (std::size_t i = 0; i < edges / 4; ++i) add(s, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  return s;
}

/// Triangles around one vertex.
RegionSet fan(std::size_t edges) {
  const std::size_t n = edges / 3;
  RegionSet s;
  for (std::size_t i = 0; i < n; ++i) {
    const double turn = static_cast<double>(i) / static_cast<double>(n);
    add(s, {{0, 0}, on_circle(1, turn), on_circle(1, turn + 0.5 / static_cast<double>(n))});
  }
  return s;
}

RegionSet nested_squares(std::size_t edges) {
  RegionSet s;
  for (std::size_t i = 1; i <= edges / 4; ++i) {
    const auto r = static_cast<double>(i);
    add(s, {{-r, -r}, {r, -r}, {r, r}, {-r, r}});
  }
  return s;
}

/// A comb whose teeth enter another's from above.
RegionSet combs(std::size_t edges) {
  const std::size_t teeth = edges / 4;
  std::vector<Point> comb{{0, -1}, {static_cast<double>(teeth), -1}};
  for (std::size_t i = teeth; i-- > 0;) {
    const auto x = static_cast<double>(i);
    comb.push_back({x + 0.9, static_cast<double>(i % 7) * 0.01 + 50});
    comb.push_back({x + 0.5, 0});
  }
  std::vector<Point> other;
  for (const Point& p : comb) other.push_back({p.x + 0.13, 99.9 - p.y});
  RegionSet s;
  add(s, comb);
  add(s, other);
  return s;
}

/// A star of a tenth of the edges, and small triangles in and beside it.
RegionSet huge_and_tiny(std::size_t edges) {
  Random random(7);
  const std::size_t n = edges * 9 / 30, m = edges / 20 * 2;
  std::vector<Point> star;
  for (std::size_t i = 0; i < m; ++i)
    star.push_back(on_circle(i % 2 == 0 ? 990 : 1000, static_cast<double>(i) / static_cast<double>(m)));
  RegionSet s;
  add(s, star);
  const double w = 800 / std::sqrt(static_cast<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    const double x = random.in(-1000, 1000), y = random.in(-1000, 1000);
    add(s, {{x, y}, {x + w, y}, {x + w / 2, y + w}});
  }
  return s;
}

/// Slanted lines of one operand clipped by two tiles that share part of an edge.
Operands hatch(std::size_t edges) {
  const auto turned = [](double x, double y) -> Point {
    const double c = 0.9553364891256060, s = 0.2955202066613396;  // of 0.3
    return {x * c - y * s, x * s + y * c};
  };
  Operands operands;
  const std::size_t lines = (edges - 8) / 4;
  const double step = 100 / static_cast<double>(lines), width = 0.4 * step;
  for (std::size_t i = 0; i < lines; ++i) {
    const double y = (static_cast<double>(i) + 0.25) * step - 50;
    add(operands.a, {turned(-60, y), turned(60, y), turned(60, y + width), turned(-60, y + width)});
  }
  add(operands.b, {{-30, -30}, {0, -30}, {0, 30}, {-30, 30}});
  add(operands.b, {{0, -29}, {30, -29}, {30, 31}, {0, 31}});
  return operands;
}

/// Long thin triangles through nearly one point in nearly one direction; about half of all pairs of edges meet.
Operands needles(std::size_t edges) {
  Random random(1);
  Operands operands;
  const double near = 3e-16, dx = 0.4535961214255773, dy = 0.8912073600614354;  // of 1.1
  const auto about_0 = [&] { return random.in(-near, near); };
  const auto count = static_cast<std::size_t>(std::sqrt(static_cast<double>(edges)) / 3);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = about_0(), u = about_0(), l = random.in(0.1, 10), m = random.in(0.1, 10);
    const Point o{3.7 + about_0(), -2.9 + about_0()};
    // Turned by t and by u from the common direction.
    add(i % 2 == 0 ? operands.b : operands.a, {{o.x - l * (dx - t * dy), o.y - l * (dy + t * dx)},
                                               {o.x + m * (dx - t * dy), o.y + m * (dy + t * dx)},
                                               {o.x + l * (dx - u * dy), o.y + l * (dy + u * dx)}});
  }
  return operands;
}

/// Bursts: a hundred thin triangles through nearly one place each, in all directions; places far from each other.
RegionSet bursts(std::size_t edges) {
  Random random(7);
  RegionSet s;
  const std::size_t places = std::max<std::size_t>(1, edges / 300);
  const auto columns = static_cast<std::size_t>(std::sqrt(static_cast<double>(places))) + 1;
  for (std::size_t p = 0; p < places; ++p) {
    const Point place{4.0 * static_cast<double>(p % columns), 4.0 * static_cast<double>(p / columns)};
    for (int i = 0; i < 100; ++i) {
      const double turn = random.unit();
      const Point there = on_circle(1, turn), back = on_circle(1, turn + 0.5), beside = on_circle(1, turn + 0.5 + 1e-9);
      const double dx = random.in(-1e-12, 1e-12), dy = random.in(-1e-12, 1e-12);
      add(s, {{place.x + there.x + dx, place.y + there.y + dy},
              {place.x + back.x + dx, place.y + back.y + dy},
              {place.x + beside.x + dx, place.y + beside.y + dy}});
    }
  }
  return s;
}

/// Triangles of sizes from 2^-20 to 2^20, at distances from the origin as large as they are: a few at each size reach
/// each other. All are in one input, so the largest coordinate says nothing about most of it.
RegionSet mixed_magnitudes(std::size_t edges) {
  Random random(7);
  RegionSet s;
  for (std::size_t i = 0; i < edges / 3; ++i) {
    const double scale = std::ldexp(1.0, random.between(-20, 20)), size = 4 / std::sqrt(static_cast<double>(edges));
    const double x = scale * random.in(1, 2), y = scale * random.in(1, 2), w = scale * size;
    add(s, {{x, y}, {x + w, y}, {x + w / 2, y + w}});
  }
  return s;
}

/// Small triangles side by side inside one of 2^60 times their size: all of them lie within a few units in the last
/// place of its coordinates.
RegionSet one_around(std::size_t edges) {
  RegionSet s = one_x(edges - 3);
  add(s, {{-0x1p60, -0x1p60}, {0x1p60, -0x1p60}, {-0x1p60, 0x1p60}});
  return s;
}

/// A family of the first form is united, one of the second intersected.
struct Family {
  const char* name;
  std::function<RegionSet(std::size_t)> make;
  std::function<Operands(std::size_t)> make_two = {};

  Operands operands(std::size_t edges) const { return make ? Operands{make(edges), {}} : make_two(edges); }
};

const Family families[] = {{"long_slabs", long_slabs},
                           {"one_x", one_x},
                           {"copies", copies},
                           {"fan", fan},
                           {"nested_squares", nested_squares},
                           {"combs", combs},
                           {"huge_and_tiny", huge_and_tiny},
                           {"hatch", {}, hatch},
                           {"needles", {}, needles},
                           {"bursts", bursts},
                           {"mixed_magnitudes", mixed_magnitudes},
                           {"one_around", one_around}};

struct Measured {
  std::uint64_t edges = 0, intersections = 0;
  double seconds = 0;
  double bytes = 0;

  double work() const { return static_cast<double>(edges + intersections); }
  double time_per() const { return seconds / (work() * std::log2(work())); }
  double memory_per() const { return bytes / work(); }
};

double peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024;
}

/// The fastest of a few runs.
Measured measure_here(const Family& family, std::size_t edges) {
  const auto [a, b] = family.operands(edges);
  const Operation operation = family.make ? Operation::unite : Operation::intersection;
  const double before = peak_bytes();
  Measured measured;
  measured.edges = a.points.size() + b.points.size();
  measured.seconds = 1e30;
  double all = 0;
  for (int run = 0; run < 5 && (run == 0 || all < 2); ++run) {
    Statistics statistics;
    Options options;
    options.threads = 1;
    options.statistics = &statistics;
    const auto begin = std::chrono::steady_clock::now();
    const RegionSet result = overlay(a, b, operation, options);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    all += seconds;
    measured.seconds = std::min(measured.seconds, seconds);
    measured.intersections = statistics.intersections;
    if (run == 0) measured.bytes = peak_bytes() - before;
  }
  return measured;
}

Measured measure(const Family& family, std::size_t edges) {
  int ends[2];
  Measured measured;
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child == 0) {
    measured = measure_here(family, edges);
    _exit(write(ends[1], &measured, sizeof measured) == sizeof measured ? 0 : 1);
  }
  close(ends[1]);
  const bool complete = read(ends[0], &measured, sizeof measured) == sizeof measured;
  close(ends[0]);
  waitpid(child, nullptr, 0);
  if (!complete) throw std::runtime_error(fmt::format("{} at {} edges did not finish", family.name, edges));
  return measured;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Growth of time and memory on adversarial families; both divided by what is promised.");
  std::size_t edges = 100000;
  int steps = 4;
  std::vector<std::string> names;
  app.add_option("--edges", edges, "of the smallest case")->capture_default_str();
  app.add_option("--steps", steps, "each has twice the edges of the one before")->capture_default_str();
  app.add_option("FAMILY", names, "only these");
  CLI11_PARSE(app, argc, argv);
  fmt::print("{:<16} {:>9} {:>10} {:>9} {:>7} {:>10} {:>7}\n", "family", "edges", "meetings", "seconds", "ratio", "MiB",
             "ratio");
  try {
    for (const Family& family : families) {
      if (!names.empty() && std::find(names.begin(), names.end(), family.name) == names.end()) continue;
      Measured first;
      for (int step = 0; step < steps; ++step) {
        const Measured m = measure(family, edges << step);
        if (step == 0) first = m;
        fmt::print("{:<16} {:>9} {:>10} {:>9.3f} {:>7.2f} {:>10.1f} {:>7.2f}\n", family.name, m.edges, m.intersections,
                   m.seconds, m.time_per() / first.time_per(), m.bytes / 0x1p20, m.memory_per() / first.memory_per());
        std::fflush(stdout);
      }
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
