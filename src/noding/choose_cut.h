// Which cut divides the runs of a cell best: judged on a random sample of them.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <span>

#include "noding/cell_cut.h"
#include "noding/monotone_runs.h"

namespace oblast::internal::noding {

/// What of a run that is on both sides of a cut goes to a side.
enum class RunParts : std::uint8_t { edges, whole };

/// The better median cut of the two axes, on a random sample.
CellCut best_run_cut(std::span<const Run> runs, RunParts parts);

/// The best of the axis cuts and of some edges of the sample, for clipped edges.
/// `may_part` says whether edges with margins may be missed as CellCut::parts_touching says.
CellCut best_cut(std::span<const Point> points, std::span<const Run> runs, const Box& cell, bool may_part);

/// A run that, if it went through the cell along the axis, would reach about one of the `count` others in it.
bool is_flat(const Run& run, Axis axis, const Box& cell, std::size_t count);

}  // namespace oblast::internal::noding
