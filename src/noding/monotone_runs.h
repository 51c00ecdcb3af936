// Monotone runs: maximal stretches of a strand along which neither coordinate turns back.
//
// A run never meets itself and its box is spanned by its two ends, so the search for meetings starts
// from runs instead of single edges.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "base/large_pages.h"
#include "base/tuning.h"
#include "noding/strands.h"
#include "plane/box.h"

namespace oblast::internal::noding {

/// Edges of a run at most.
inline constexpr std::uint32_t longest_run = tuning::longest_run;

struct Run {
  Box box;
  std::uint32_t first;  ///< first edge
  std::uint32_t last;   ///< past the last edge, which is also the index of the last vertex
  Group group;
  std::uint32_t marks = 0;  ///< marks_of(); one word, for runs are copied much

  /// Its strand goes on, in x or in y, from the edge before to its first. So the run meets the one before nowhere but
  /// in the vertex between them.
  std::uint32_t goes_on() const { return marks & 1; }
  /// How near others may come and are looked for: the box is wider by this. 0 or a power of two.
  double margin() const { return std::bit_cast<double>(static_cast<std::uint64_t>(marks >> 1) << 52); }

  /// The margin is rounded up to a power of two. REQUIRES: 0, or a normal number.
  static std::uint32_t marks_of(bool goes_on, double margin) {
    const auto bits = std::bit_cast<std::uint64_t>(margin);
    const auto exponent = static_cast<std::uint32_t>(bits >> 52) + ((bits << 12) != 0);
    return exponent << 1 | static_cast<std::uint32_t>(goes_on);
  }
};

/// Which groups the runs of a round get.
enum class Grouping {
  by_strand,  ///< first round: the group of the strand
  none,       ///< first round: all may meet all
  by_moved,   ///< later rounds: pieces made by the last round may meet anything, all others are settled
};

/// What a search for edges that come near each other needs.
struct RunMargins {
  double vertex = 0;  ///< a strand goes on at a vertex if it does so by more than this on either side
  double ulps = 0;    ///< margin of each run, in units in the last place of its own largest coordinate
};

/// Pieces flagged repeated_flag are left out. Cost: linear.
LargeArray<Run> monotone_runs(const Strands& strands, Grouping grouping, const RunMargins& margins = {});

}  // namespace oblast::internal::noding
