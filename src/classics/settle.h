// If rounding might change what meets what (clearance.h), a classic passes its operands on to `overlay`, which repeats
// rounding until nothing changes.
#pragma once

#include <oblast/classics.h>
#include <oblast/overlay.h>

#include "base/public_call.h"
#include "regions/validate.h"

namespace oblast::internal::classics {

inline RegionSet settle(const RegionView& a, const RegionView& b, Operation operation, ClassicReport& report,
                        const Options& options) {
  report.handed_over = true;
  return overlay(a, b, operation, options);
}

/// The options of an overlay that a classic makes, with one fill rule for both operands.
inline Options overlay_options(const CallOptions& call, const FillRule& rule = {}) {
  Options options;
  static_cast<CallOptions&>(options) = call;
  options.fill_a = options.fill_b = rule;
  return options;
}

/// The frame of a classic on two operands: validates them, and runs work(report) in a call.
template <class Work>
RegionSet classic_call(const RegionView& a, const RegionView& b, ClassicReport* report, const CallOptions& options,
                       const Work& work) {
  ClassicReport unused;
  ClassicReport& done = report ? *report : unused;
  done = {};
  return public_call(options, a.points.size() + b.points.size(), [&](Control&) {
    validate(a, 0);
    validate(b, 1);
    return work(done);
  });
}

}  // namespace oblast::internal::classics
