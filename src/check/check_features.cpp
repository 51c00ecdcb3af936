// Each feature by itself: its rings, where their edges meet, and how they nest.
#include <oblast/check_features.h>

#include <algorithm>
#include <mutex>

#include "base/parallel.h"
#include "base/public_call.h"
#include "base/tuning.h"
#include "check/feature_form.h"
#include "check/feature_rings.h"
#include "check/valid_feature.h"

namespace oblast {
using namespace internal;
namespace {

using checking::FeatureRings;
using checking::RingRoles;

bool is_listed(std::span<const std::uint32_t> sorted, std::uint32_t i) {
  return std::binary_search(sorted.begin(), sorted.end(), i);
}

void check_feature(const FeatureView& features, std::uint32_t f, const FeatureCheckOptions& options,
                   FeatureRings& rings, std::vector<FeatureFault>& faults) {
  const bool without_roles = is_listed(options.features_without_roles, f);
  checking::find_feature_faults({features, f}, without_roles ? RingRoles::none : RingRoles::given, rings, faults);
}

std::size_t vertices_of(const FeatureView& features, std::uint32_t f) {
  const RegionView& regions = features.regions;
  const std::uint32_t begin = features.feature_begin(f), end = features.feature_end(f);
  if (begin == end) return 0;
  const std::uint32_t from = regions.polygon_begin(begin), past = regions.polygon_end(end - 1);
  return from == past ? 0 : regions.contour_end(past - 1) - regions.contour_begin(from);
}

std::vector<FeatureFault> find_all(const FeatureView& features, const FeatureCheckOptions& options) {
  std::vector<FeatureFault> faults;
  std::mutex mutex;
  const auto add = [&](const std::vector<FeatureFault>& found) {
    if (found.empty()) return;
    const std::lock_guard lock(mutex);
    faults.insert(faults.end(), found.begin(), found.end());
  };
  const std::size_t count = features.feature_count();
  for_ranges(count, grain(count, features.regions.points.size()), [&](std::size_t begin, std::size_t end) {
    FeatureRings rings;
    std::vector<FeatureFault> found;
    for (std::size_t f = begin; f < end; ++f) {
      poll();
      const auto feature = static_cast<std::uint32_t>(f);
      if (vertices_of(features, feature) <= tuning::parts_a_task)
        check_feature(features, feature, options, rings, found);
    }
    add(found);
  });
  FeatureRings rings;
  std::vector<FeatureFault> found;
  for (std::uint32_t f = 0; f < count; ++f)
    if (vertices_of(features, f) > tuning::parts_a_task) check_feature(features, f, options, rings, found);
  add(found);
  checking::add_open_contours(features, options.open_contours, faults);
  checking::put_in_order(faults);
  return faults;
}

}  // namespace

std::vector<FeatureFault> check_features(const FeatureView& features, const FeatureCheckOptions& options) {
  return public_call(options, features.regions.points.size(), [&](Control&) {
    checking::validate_features(features);
    return find_all(features, options);
  });
}

}  // namespace oblast
