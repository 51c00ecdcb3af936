// Converts the exact result of clipping to points: rounds crossings, and decides whether that is safe.
#pragma once

#include "base/call_memory.h"
#include "classics/half_plane_clip.h"
#include "window/contours.h"

namespace oblast::internal::classics {

bool has_safe_magnitudes(const Array<Ring>& rings);

/// Adds the contours of the result. False if rounding might change what meets what (clearance.h). Sets `meetings` to
/// the number of points that are on both boundaries.
bool round_clip(const HalfPlaneClip& clip, const Array<Ring>& subject, const ConvexWindow& window,
                window::Contours& contours, std::uint64_t& meetings);

}  // namespace oblast::internal::classics
