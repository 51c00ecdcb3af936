// From what a step found to what the caller is told.
#pragma once

#include <oblast/check.h>

#include "check/finding.h"

namespace oblast::internal::checking {

/// REQUIRES: offsets are right.
Fault report_of(const RegionView& regions, const Finding& finding);

}  // namespace oblast::internal::checking
