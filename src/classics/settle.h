// What a classic does when rounding might change what meets what (clearance.h): it hands its operands to the
// settled noding of the library, which repeats rounding until nothing changes and labels by winding numbers.
#pragma once

#include <oblast/classics.h>
#include <oblast/overlay.h>

namespace oblast::classics {

inline RegionSet settle(const RegionView& a, const RegionView& b, Operation operation, ClassicReport& report,
                        const Options& options = {}) {
  report.handed_over = true;
  return overlay(a, b, operation, options);
}

}  // namespace oblast::classics
