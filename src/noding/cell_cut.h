// A cut of a cell in two, and what it does to the boxes in it. See pair_finder.h.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <limits>
#include <span>

#include "base/call_memory.h"
#include "noding/monotone_runs.h"

namespace oblast::internal::noding {

/// A run, or a single edge, with the box of what of it is in the cell, wider by its margin. It is on every side of a
/// cut that it, as wide as its margin, reaches.
using Entry = Run;

enum class Axis : std::uint8_t { x, y };

inline double low(const Box& box, Axis axis) { return axis == Axis::x ? box.x0 : box.y0; }
inline double high(const Box& box, Axis axis) { return axis == Axis::x ? box.x1 : box.y1; }

/// Where a cut runs: at a value of x or of y, or along the line of an edge.
enum class CutKind : std::uint8_t { at_x, at_y, along_edge };

struct CellCut {
  CutKind kind = CutKind::at_x;
  double at = 0;           ///< for at_x and at_y
  std::uint32_t edge = 0;  ///< for along_edge
  /// Along an edge: others with a margin that touch it in a vertex are on one side only. So a fan can be divided, but
  /// what comes near them on the other side is missed. (Without a margin they are on one side in any case: what they
  /// meet on the other, the edge meets too.)
  bool parts_touching = true;
  /// Edges in both halves over edges in the cell, by a sample; infinite for a cut that does not help.
  double growth = std::numeric_limits<double>::infinity();
};

/// What of an entry is left and right of a cut. Left is below, for at_y.
struct Sides {
  bool left = false, right = false;
  Entry left_part, right_part;
  bool touches = false;  ///< an edge kept from one side although it comes within its margin of it, in a vertex
};

/// By the edges of a run, in whose direction its coordinates never turn back: each goes to the sides it reaches.
/// Without points the whole run goes.
Sides divide_run(std::span<const Point> points, const Entry& entry, const CellCut& cut);

/// The same for entries[begin..]: what of them is left of the cut stays in their place, up to the returned index; what
/// is right of it is appended to `right`.
std::size_t divide_runs(std::span<const Point> points, LargeArray<Entry>& entries, std::size_t begin,
                        const CellCut& cut, LargeArray<Entry>& right);

/// For an entry of one edge: what lies on either side, or within its margin of it, clipped. Rounded outwards: nothing
/// is lost.
Sides divide_edge(std::span<const Point> points, const Entry& entry, const CellCut& cut);

/// What of a run that is on both sides of a cut goes to a side.
enum class RunParts : std::uint8_t { edges, whole };

/// The better median cut of the two axes, on a random sample.
CellCut best_run_cut(std::span<const Entry> entries, RunParts parts);

/// The best of the axis cuts and of some edges of the sample, for clipped entries of one edge.
/// `may_part` says whether entries with margins may be missed as CellCut::parts_touching says.
CellCut best_cut(std::span<const Point> points, std::span<const Entry> entries, const Box& cell, bool may_part);

/// An entry that, if it went through the cell along the axis, would reach about one of the `count` others in it.
bool is_flat(const Entry& entry, Axis axis, const Box& cell, std::size_t count);

}  // namespace oblast::internal::noding
