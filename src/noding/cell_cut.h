// A cut of a cell in two, and what it does to the runs in it. See pair_finder.h.
//
//          left      |      right
//      .-------------+-------------.      Each run has the box of what of it is in the cell, wider by the run's margin.
//      |   .--.      |             |      It goes to each side that this box reaches; to both, it is divided:
//      |   |r |   .--+--------.    |
//      |   '--'   | s:        |    |      r    left only
//      |          '--+--------'    |      s    left up to its last edge that reaches the left side, and right from
//      '-------------+-------------'           its first edge that reaches the right side
//
// A run of one edge, which cannot be divided into edges, is clipped: its box becomes that of a part of the edge.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <limits>
#include <span>

#include "base/call_memory.h"
#include "noding/monotone_runs.h"

namespace oblast::internal::noding {

enum class Axis : std::uint8_t { x, y };

inline double low(const Box& box, Axis axis) { return axis == Axis::x ? box.x0 : box.y0; }
inline double high(const Box& box, Axis axis) { return axis == Axis::x ? box.x1 : box.y1; }

/// Where a cut runs: at a value of x or of y, or along the line of an edge.
enum class CutKind : std::uint8_t { at_x, at_y, along_edge };

/// REQUIRES: at_x or at_y.
inline Axis axis_of(CutKind kind) { return kind == CutKind::at_x ? Axis::x : Axis::y; }
inline double low(const Box& box, CutKind kind) { return low(box, axis_of(kind)); }
inline double high(const Box& box, CutKind kind) { return high(box, axis_of(kind)); }

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

/// What of a run is left and right of a cut. Left is below, for at_y.
struct Sides {
  bool left = false, right = false;
  Run left_part, right_part;
  bool touches = false;  ///< an edge kept from one side although it comes within its margin of it, in a vertex
};

/// By the edges of a run, in whose direction its coordinates never turn back: each goes to the sides it reaches.
/// Without points the whole run goes.
Sides divide_run(std::span<const Point> points, const Run& run, const CellCut& cut);

/// The same for runs[begin..]: what of them is left of the cut stays in their place, up to the returned index; what
/// is right of it is appended to `right`.
std::size_t divide_runs(std::span<const Point> points, LargeArray<Run>& runs, std::size_t begin, const CellCut& cut,
                        LargeArray<Run>& right);

/// For a run of one edge: what lies on either side, or within its margin of it, clipped. Rounded outwards: nothing
/// is lost.
Sides divide_edge(std::span<const Point> points, const Run& run, const CellCut& cut);

}  // namespace oblast::internal::noding
