// Whether edges meet elsewhere than at common ends.
#pragma once

#include <optional>

#include "check/finding.h"
#include "noding/strands.h"

namespace oblast::internal::checking {

/// The first two edges that do. Where contours touch at a vertex it is flagged node_flag, and with it the ends of the
/// strand. REQUIRES: no edge of length zero, at least three edges a strand. Cost: O((n + k) log n), on all cores.
std::optional<Finding> find_bad_meeting(noding::Strands& strands);

}  // namespace oblast::internal::checking
