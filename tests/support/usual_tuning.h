// With tiny constants (src/base/tuning.h) what may give up, or look coarsely, does so sooner. What it says is still
// right.
#pragma once

#include "base/tuning.h"

namespace oblast::testing {
using namespace internal;

inline constexpr bool usual_tuning = tuning::setting == tuning::Setting::usual;

}  // namespace oblast::testing
