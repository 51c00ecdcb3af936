// Overlay and union: the main functions of the library.
#pragma once

#include <oblast/error.h>
#include <oblast/export.h>
#include <oblast/options.h>
#include <oblast/region_set.h>

namespace oblast {

/// The overlay of two operands, A op B. The fill rule of each operand decides what is inside it (Options::fill_a,
/// fill_b).
///
/// Any finite coordinates in the domain are allowed, and any contours (see domain.h and RegionView). The result is
/// closed and canonical, and input vertices keep their bits: promises G1 to G4, docs/guarantees.md.
/// Cost: expected O((n + k) log n) time and O(n + k) memory for n edges with k meetings. docs/guarantees.md (G6) names
/// one case that takes longer: bundles of edges within a few units in the last place of each other.
/// Throws Error: not_finite, out_of_domain, too_large, bad_offsets, bad_option, cancelled, memory_limit;
/// std::bad_alloc; and what Options::progress throws. The exception is thrown once, on the caller's thread, even if
/// another thread raised it. Nothing leaks, and later calls are not affected.
///
/// Several calls may run at the same time on any threads, also on the same input, as long as no thread changes it.
/// With Options::threads 0 a call works in the caller's oneTBB arena. It may be made in a oneTBB task; if the caller
/// cancels that task, the call still returns the right result. With Options::threads 1 a call stays on the caller's
/// thread.
OBLAST_API RegionSet overlay(const RegionView& a, const RegionView& b, Operation operation,
                             const Options& options = {});

/// Writes the same overlay to `result`. It reuses the arrays of `result` if they have room, which saves memory
/// allocations when calls follow one another. An operand may be a view of `result` or of a part of it; then new arrays
/// are made. If the call throws, `result` is unchanged or empty.
OBLAST_API void overlay(const RegionView& a, const RegionView& b, Operation operation, const Options& options,
                        RegionSet& result);

/// The union of any number of polygons in one pass. The fill rule is `options.fill_a`. Uniting a result again does not
/// change it: `unite(unite(x)) == unite(x)`, bit for bit. Cost and errors as for `overlay`.
OBLAST_API RegionSet unite(const RegionView& regions, const Options& options = {});

/// Writes the same union to `result`, as the `overlay` above does.
OBLAST_API void unite(const RegionView& regions, const Options& options, RegionSet& result);

}  // namespace oblast
