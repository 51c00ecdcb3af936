// oblast_locate: a million points, whether they are inside of regions, by Locator, GEOS and Boost.Geometry.
//
//   oblast_locate [--geos LIBGEOS_C.SO] [--points N] [--rounds N] REGIONS...
//
// All contestants run in one process and take turns; a figure is the least of the rounds, in processor time of one
// thread, or in time by the clock for who uses all cores. All are asked in the same
// order, and all answers are compared with the true ones. Who would take more than some seconds a round is asked fewer
// of the points, and the table says so. `ratio` is the time of the best way of the best other library by ours.
#include <fmt/format.h>
#include <oblast/version.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ctime>
#include <exception>

#include "locate/contestant.h"
#include "locate/inputs.h"

namespace oblast::bench {
namespace {

struct Arguments {
  std::string geos;
  std::size_t points = 1'000'000;
  int rounds = 5;
  bool only_oblast = false;
  std::vector<std::string> regions;
};

/// One contestant on one set of points.
struct Row {
  Contestant* contestant = nullptr;
  std::size_t asked = 0;
  double best_ns = 1e300;  ///< a point
  std::size_t wrong = 0;
  std::vector<std::uint8_t> answers;
};

/// Of a clock: CLOCK_MONOTONIC, or what this thread has had of a processor.
double now(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}
template <class Work>
double seconds_of(const Contestant& contestant, const Work& work) {
  const clockid_t clock = contestant.on_all_cores() ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID;
  const double start = now(clock);
  work();
  return now(clock) - start;
}

void ask(Row& row, const std::vector<Point>& points) {
  const auto asked = std::span(points).first(row.asked);
  const double seconds =
      seconds_of(*row.contestant, [&] { row.contestant->ask(asked, std::span(row.answers).first(row.asked)); });
  row.best_ns = std::min(row.best_ns, seconds * 1e9 / static_cast<double>(row.asked));
}

void measure(std::vector<Row>& rows, const std::vector<Point>& points, int rounds) {
  constexpr std::size_t first = 1000;
  constexpr double most_seconds = 2;
  for (Row& row : rows) {
    row.answers.resize(points.size());
    row.asked = std::min(points.size(), first);
    ask(row, points);
    const auto affordable = static_cast<std::size_t>(most_seconds * 1e9 / row.best_ns);
    row.asked = std::min(points.size(), std::max(affordable, first));
    row.best_ns = 1e300;
  }
  for (int round = 0; round < rounds; ++round)
    for (Row& row : rows) ask(row, points);
}

void print_rows(std::vector<Row>& rows, const std::vector<Location>& truth) {
  double best_other = 1e300;
  for (Row& row : rows) {
    for (std::size_t i = 0; i < row.asked; ++i) {
      const bool expected =
          truth[i] == Location::inside || (truth[i] == Location::boundary && row.contestant->with_boundary());
      if ((row.answers[i] != 0) != expected) ++row.wrong;
    }
    if (row.contestant->library() != "oblast") best_other = std::min(best_other, row.best_ns);
  }
  for (const Row& row : rows) {
    fmt::print("  {:44} {:10.1f} ns {:10} asked {:7} wrong", row.contestant->name(), row.best_ns, row.asked, row.wrong);
    if (row.contestant->library() == "oblast" && best_other < 1e300)
      fmt::print("   ratio {:.1f}", best_other / row.best_ns);
    fmt::print("\n");
  }
}

void compare(const std::string& name, std::vector<std::unique_ptr<Contestant>>& contestants,
             const Arguments& arguments) {
  const RegionSet regions = regions_named(name);
  fmt::print("\n{}: {} polygons, {} contours, {} vertices\n", name, regions.polygon_ends.size(),
             regions.contour_ends.size(), regions.points.size());
  std::vector<double> build(contestants.size(), 1e300);
  for (const auto& contestant : contestants) contestant->load(regions);
  for (int round = 0; round < std::min(arguments.rounds, 3); ++round)
    for (std::size_t i = 0; i < contestants.size(); ++i)
      build[i] = std::min(build[i], seconds_of(*contestants[i], [&] { contestants[i]->build(); }));
  for (std::size_t i = 0; i < contestants.size(); ++i)
    fmt::print("  {:44} {:10.2f} ms to prepare\n", contestants[i]->name(), build[i] * 1e3);

  for (const bool near : {false, true}) {
    const std::vector<Point> points =
        near ? points_half_near_vertices(regions, arguments.points) : points_all_over(regions, arguments.points);
    const std::vector<Location> truth = true_locations(regions, points);
    const auto count = [&](Location location) { return std::count(truth.begin(), truth.end(), location); };
    fmt::print(" {} points {}: {} inside, {} on the boundary\n", points.size(),
               near ? "half of which are near vertices" : "all over", count(Location::inside),
               count(Location::boundary));
    std::vector<Row> rows;
    for (const auto& contestant : contestants) rows.emplace_back().contestant = contestant.get();
    measure(rows, points, arguments.rounds);
    print_rows(rows, truth);
    std::fflush(stdout);
  }
}

int run(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Point-in-region queries by oblast, GEOS and Boost.Geometry.");
  app.add_option("--geos", arguments.geos, "libgeos_c.so of GEOS 3.12 or newer; without it GEOS is left out");
  app.add_option("--points", arguments.points);
  app.add_option("--rounds", arguments.rounds);
  app.add_flag("--only-oblast", arguments.only_oblast, "no others, as for a profile");
  app.add_option("REGIONS", arguments.regions,
                 "a workload file (its operand A, united), circle:VERTICES, star:VERTICES or snowflake:LEVEL")
      ->required();
  CLI11_PARSE(app, argc, argv);
  std::vector<std::unique_ptr<Contestant>> contestants = oblast_contestants();
  const auto add = [&](std::vector<std::unique_ptr<Contestant>> more) {
    std::move(more.begin(), more.end(), std::back_inserter(contestants));
  };
  if (!arguments.geos.empty() && !arguments.only_oblast) add(geos_contestants(arguments.geos));
  if (!arguments.only_oblast) add(boost_contestants());
  for (const std::string& name : arguments.regions) compare(name, contestants, arguments);
  return 0;
}

}  // namespace
}  // namespace oblast::bench

int main(int argc, char** argv) {
  try {
    return oblast::bench::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "oblast_locate: {}\n", error.what());
    return 1;
  }
}
