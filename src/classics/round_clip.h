// The exact result of clipping to points: crossings rounded, and told whether that is safe.
#pragma once

#include "base/call_memory.h"
#include "classics/half_plane_clip.h"
#include "window/contours.h"

namespace oblast::internal::classics {

bool has_safe_magnitudes(const Array<Ring>& rings);

/// Adds the contours of the result. False when rounding might change what meets what (clearance.h).
/// `meetings`: points of both boundaries.
bool round_clip(const HalfPlaneClip& clip, const Array<Ring>& subject, const ConvexWindow& window,
                window::Contours& contours, std::uint64_t& meetings);

}  // namespace oblast::internal::classics
