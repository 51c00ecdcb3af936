// Hostile input: two operands whose edges coincide, nearly coincide, or meet in crowds.
//
// Each generator is a pure function of a seed and a size, the same on every machine. Tests, the hostile
// runner and the fuzzers share the list.
#pragma once

#include <oblast/region_set.h>

#include <cstdint>
#include <span>

namespace oblast::generators {

/// Two operands of an overlay. Coordinates are in the domain; contours may be degenerate.
struct Operands {
  RegionSet a;
  RegionSet b;
};

struct HostileGenerator {
  const char* name;
  const char* what;  ///< one sentence
  /// `size`: the approximate number of edges of both operands together; 8 or more.
  Operands (*make)(std::uint64_t seed, int size);
  int usual = 60;      ///< the largest size at which a case takes milliseconds, for runs over very many cases
  int larger = 500;    ///< a size at which a case has at most many thousand meetings, for tests that should be fast
  int largest = 4000;  ///< a size at which a call takes some tenths of a second, for a few among very many cases
};

/// All of them, in a fixed order.
std::span<const HostileGenerator> hostile_generators();

// lattice.cpp: where everything coincides
Operands integer_grid(std::uint64_t seed, int size);
Operands grid_by_an_ulp(std::uint64_t seed, int size);
Operands copies_of_one_square(std::uint64_t seed, int size);
Operands nested_squares(std::uint64_t seed, int size);
Operands checkerboards(std::uint64_t seed, int size);

// bundles.cpp: many edges through one point
Operands near_parallel_bundles(std::uint64_t seed, int size);
Operands fans(std::uint64_t seed, int size);
Operands combs(std::uint64_t seed, int size);
Operands stars(std::uint64_t seed, int size);

// borders.cpp: edges that lie on one line, exactly or nearly
Operands t_junctions(std::uint64_t seed, int size);
Operands vertices_on_edges(std::uint64_t seed, int size);
Operands slivers(std::uint64_t seed, int size);
Operands coverages(std::uint64_t seed, int size);

// scales.cpp: usual and very unusual magnitudes of coordinates
Operands spirals(std::uint64_t seed, int size);
Operands magnitudes(std::uint64_t seed, int size);
Operands earth_degrees(std::uint64_t seed, int size);
Operands earth_metres(std::uint64_t seed, int size);
Operands far_from_origin(std::uint64_t seed, int size);

// fed_back.cpp: results of earlier operations
Operands fed_back(std::uint64_t seed, int size);

}  // namespace oblast::generators
