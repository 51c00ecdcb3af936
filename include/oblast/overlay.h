// Overlay and union: what the library is for.
#pragma once

#include <oblast/error.h>
#include <oblast/export.h>
#include <oblast/options.h>
#include <oblast/region_set.h>

namespace oblast {

/// The overlay of two operands: A op B, where inside and outside of each follow its fill rule.
///
/// Any finite input inside the domain is admitted (see RegionView and domain.h). The result is
/// closed, canonical and bit-preserving: promises G1 to G4, docs/guarantees.md.
/// Cost: O((n + k) log n) time and O(n + k) memory, n edges and k meetings of edges.
/// Throws Error: not_finite, out_of_domain, too_large, bad_offsets, bad_option, cancelled, memory_limit;
/// std::bad_alloc; and what Options::progress throws. Whatever is thrown, on whichever thread, it comes out once and as
/// it is, nothing leaks and the next call is not affected.
///
/// Calls may run side by side on any threads, on the same input too, as long as nobody writes to it. With
/// Options::threads 0 a call takes part in the caller's oneTBB arena; it may be made from within his own tasks, also
/// ones that he cancels: then it ends as it would have. With 1 it stays on the caller's thread.
OBLAST_API RegionSet overlay(const RegionView& a, const RegionView& b, Operation operation,
                             const Options& options = {});

/// The same into `result`, in whose arrays it is put where they have room, so that calls in a row need no new ones. An
/// operand may be a view of `result` or of a part of it; then the arrays are new. Where something is thrown, `result`
/// is as it was or empty.
OBLAST_API void overlay(const RegionView& a, const RegionView& b, Operation operation, const Options& options,
                        RegionSet& result);

/// The union of any number of polygons in one pass; `options.fill_a` is its rule.
/// `unite(unite(x)) == unite(x)`, bit for bit. Cost and errors as for `overlay`.
OBLAST_API RegionSet unite(const RegionView& regions, const Options& options = {});

/// The same into `result`, as above.
OBLAST_API void unite(const RegionView& regions, const Options& options, RegionSet& result);

}  // namespace oblast
