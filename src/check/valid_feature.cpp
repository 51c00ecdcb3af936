#include "check/valid_feature.h"

#include <algorithm>

#include "check/feature_meetings.h"
#include "check/feature_nesting.h"

namespace oblast::internal::checking {

void find_feature_faults(const FeatureSpan& feature, RingRoles roles, FeatureRings& rings,
                         std::vector<FeatureFault>& faults) {
  collect_rings(feature, rings, faults);
  if (rings.size() > 1 && roles == RingRoles::none) {
    std::vector<FeatureFault> of_no_role;
    find_feature_meetings(rings, of_no_role);
    give_roles(rings, nest_rings(rings));
  }
  Array<RingTouch> touches = find_feature_meetings(rings, faults);
  find_bad_nesting(rings, nest_rings(rings), std::move(touches), faults);
}

bool is_valid_feature(const FeatureSpan& feature) {
  FeatureRings rings;
  std::vector<FeatureFault> faults;
  find_feature_faults(feature, RingRoles::given, rings, faults);
  return std::all_of(faults.begin(), faults.end(), [](const FeatureFault& fault) { return is_note(fault.kind); });
}

}  // namespace oblast::internal::checking
