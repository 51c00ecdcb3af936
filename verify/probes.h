// The points that the oracle tests: everywhere, and near places where faults are likely.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <random>
#include <vector>

#include "verify/segments.h"

namespace oblast::verify {

enum class ProbeKind : std::uint8_t {
  anywhere,       ///< uniform in the box of everything
  by_edge,        ///< on either side of an edge of the operands or of the result
  by_vertex,      ///< near a vertex of the operands or of the result
  by_crossing,    ///< near a place where two input edges cross
  result_vertex,  ///< exactly a vertex of the result: there must be an input edge near it
};
inline constexpr int probe_kinds = 5;

struct Probe {
  Point at;
  ProbeKind kind;
};

/// A uniform number in [0, 1), the same on every machine.
inline double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

/// About `count` points. Edges and vertices are chosen at equal steps, so with enough points none is left out. Points
/// beside something are 5 to 50 units away (just outside the usual bound); some are less than 5 units away, some up to
/// a hundredth of the box. REQUIRES: there are edges.
std::vector<Probe> choose_probes(const Segments& segments, std::uint64_t count, std::uint64_t seed);

/// Up to `most` approximate places where edges of A and B cross, found in small cells around the midpoints of edges. In
/// crowded cells random pairs are tested. REQUIRES: most > 0.
std::vector<Point> some_crossings(const Segments& segments, std::size_t most, std::mt19937_64& random);

}  // namespace oblast::verify
