// Hostile generator: results of earlier operations, ten deep.
//
// Results have vertices that were rounded before. They are within an ulp of edges that still exist.
#include <oblast/overlay.h>

#include <algorithm>

#include "generators/hostile.h"
#include "generators/random.h"

namespace oblast::generators {

Operands fed_back(std::uint64_t seed, int size) {
  static constexpr int depth = 10;
  // Families with one scale each, so the next operand meets the result.
  static constexpr decltype(&fans) families[] = {integer_grid, near_parallel_bundles, fans,  stars,     t_junctions,
                                                 slivers,      vertices_on_edges,     combs, coverages, nested_squares};
  Random random(seed);
  const auto family = families[random.below(static_cast<int>(std::size(families)))];
  // Edges that nearly coincide take a time that grows with the square of their number, or worse (G6 in
  // docs/guarantees.md). Ten results on top of each other have many more of them than one case.
  if (family == near_parallel_bundles || family == stars) size = std::min(size, 60);
  Options options;
  options.threads = 1;
  RegionSet result = family(random.next(), size).a;
  for (int step = 0; step < depth && result.points.size() < static_cast<std::size_t>(4 * size); ++step) {
    const auto operation = static_cast<Operation>(random.below(4));
    const Operands next = family(random.next(), size);
    RegionSet changed = overlay(result, random.one_in(2) ? next.a : next.b, operation, options);
    if (!changed.empty()) result = std::move(changed);
  }
  return {std::move(result), family(random.next(), size).b};
}

}  // namespace oblast::generators
