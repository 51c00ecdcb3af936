// Hostile cases: alone, large, and in crowds.
#include <oblast/domain.h>

#include <algorithm>
#include <cstdio>
#include <string_view>

#include "generators/hostile.h"
#include "generators/random.h"
#include "generators/request.h"
#include "golden/inputs.h"
#include "golden/results.h"

namespace oblast::golden {
namespace {

using generators::HostileGenerator, generators::Operands, generators::Random;

/// The number of edges of a large case, which takes seconds.
constexpr int most_edges = 4000;

std::string numbered(const HostileGenerator& generator, std::uint64_t number) {
  char digits[8];
  std::snprintf(digits, sizeof digits, " %04d", static_cast<int>(number));
  return generator.name + std::string(digits);
}

/// From 8 edges to the usual size of the generator.
Operands usual_case(const HostileGenerator& generator, std::uint64_t seed) {
  return generator.make(seed, Random(seed ^ 0x517eu).between(8, generator.usual));
}

struct Box {
  double x0 = domain_largest, x1 = -domain_largest;
  void add(const RegionView& regions) {
    for (const Point& p : regions.points) x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
  }
};

void append(RegionSet& crowd, const RegionView& regions, double shift) {
  const auto points = static_cast<std::uint32_t>(crowd.points.size());
  const auto contours = static_cast<std::uint32_t>(crowd.contour_ends.size());
  for (const Point& p : regions.points) crowd.points.push_back({p.x + shift, p.y});
  for (const std::uint32_t end : regions.contour_ends) crowd.contour_ends.push_back(points + end);
  for (const std::uint32_t end : regions.polygon_ends) crowd.polygon_ends.push_back(contours + end);
}

/// `cases` cases in a row along x, seeds from `seed` on. In one of four neighbours overlap.
Operands crowd(std::span<const HostileGenerator> of, std::uint64_t seed, int cases) {
  Operands crowd;
  Random random(seed);
  double x = 0;
  for (int i = 0; i < cases; ++i) {
    const HostileGenerator& generator = of[static_cast<std::size_t>(i) % of.size()];
    const Operands one = generator.make(seed + static_cast<std::uint64_t>(i), generator.usual);
    Box box;
    box.add(one.a);
    box.add(one.b);
    if (box.x1 < box.x0) continue;
    append(crowd.a, one.a, x - box.x0);
    append(crowd.b, one.b, x - box.x0);
    x += (box.x1 - box.x0) * (random.one_in(4) ? 0.8 : 1.25) + 1;
  }
  return crowd;
}

/// Cases with all magnitudes leave no room for others beside them.
bool may_be_in_a_crowd(const HostileGenerator& generator) {
  return generator.name != std::string_view("magnitudes") && generator.name != std::string_view("far_from_origin");
}

Options drawn_options(std::uint64_t seed, int threads) {
  Options options = generators::options_of(generators::draw_request(seed));
  options.threads = threads;
  return options;
}

}  // namespace

Family hostile() {
  Family family{
      "hostile", "a thousand cases of each hostile generator, four operations, options by the seed", true, {}};
  for (const HostileGenerator& generator : generators::hostile_generators()) {
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
      family.inputs.push_back({numbered(generator, seed), [&generator, seed] {
                                 const Operands operands = usual_case(generator, seed);
                                 return four_operations(operands.a, operands.b, drawn_options(seed, 1));
                               }});
    }
  }
  return family;
}

Family other_functions() {
  Family family{"other_functions", "hull, layers and triangulation of hostile cases", true, {}};
  for (const HostileGenerator& generator : generators::hostile_generators()) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
      family.inputs.push_back({numbered(generator, seed), [&generator, seed] {
                                 RegionSet both = usual_case(generator, seed).a;
                                 append(both, usual_case(generator, seed).b, 0);
                                 return hull_layers_triangulation(both);
                               }});
    }
  }
  return family;
}

Family large() {
  Family family{"large", "hostile cases of many edges, and hostile cases side by side, four operations", false, {}};
  static std::vector<HostileGenerator> mixed;
  mixed.clear();
  for (const HostileGenerator& generator : generators::hostile_generators()) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      family.inputs.push_back({numbered(generator, seed), [&generator, seed] {
                                 const Operands operands = generator.make(seed, std::min(generator.larger, most_edges));
                                 return four_operations(operands.a, operands.b, drawn_options(seed, 0));
                               }});
    }
    if (!may_be_in_a_crowd(generator)) continue;
    mixed.push_back(generator);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      family.inputs.push_back({"crowd of " + numbered(generator, seed), [&generator, seed] {
                                 const Operands operands = crowd({&generator, 1}, 1000 * seed, 200);
                                 return four_operations(operands.a, operands.b, drawn_options(seed, 0));
                               }});
    }
  }
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    family.inputs.push_back({"crowd of all " + std::to_string(seed), [seed] {
                               const Operands operands = crowd(mixed, 1000 * seed, 1000);
                               return four_operations(operands.a, operands.b, drawn_options(seed, 0));
                             }});
  }
  return family;
}

}  // namespace oblast::golden
