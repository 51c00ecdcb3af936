// One zone: the shapes, and one distance.
#pragma once

#include <oblast/buffer.h>

#include "base/control.h"
#include "overlay/pipeline.h"

namespace oblast::internal::buffering {

/// Throws Error: bad_option if the zone leaves the domain; too_large, memory_limit, cancelled. Fills `statistics`.
/// REQUIRES: the shapes are valid.
PipelineResult zone_of(const ShapeView& shapes, double distance, const BufferOptions& options, Control& control,
                       BufferStatistics& statistics);

}  // namespace oblast::internal::buffering
