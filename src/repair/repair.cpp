// Features repaired one by one: each is resolved by itself, unless it is valid.
#include <oblast/repair.h>

#include <algorithm>

#include "base/parallel.h"
#include "base/public_call.h"
#include "base/stage_shares.h"
#include "check/valid_feature.h"
#include "features/validate_features.h"
#include "overlay/pipeline.h"
#include "regions/join_features.h"
#include "repair/describe_repair.h"
#include "repair/feature_regions.h"

namespace oblast {
using namespace internal;
using namespace internal::repairing;
namespace {

/// A feature that was not valid.
struct Change {
  Charge charge;  ///< for the regions
  RegionSet regions;
  FeatureRepair report;
};

class Repair {
 public:
  Repair(const FeatureView& layer, Control& control) : layer_(layer), control_(control) {}

  Repaired run() {
    const std::size_t count = layer_.feature_count();
    const std::size_t points = layer_.regions.points.size();
    Share* const whole = Share::current();
    const NoShare by_vertices;            // progress is counted by vertices, not by the loop
    Array<Array<Change>> changes(count);  // of each feature none or one
    for_ranges(count, grain(count, points), [&](std::size_t f, std::size_t end) {
      for (; f < end; ++f) {
        const auto part =
            static_cast<double>(feature_regions(layer_, f).points.size()) / static_cast<double>(points + 1);
        const Share share(whole, repair_share * part);
        look_at(static_cast<std::uint32_t>(f), changes[f]);
      }
    });
    Array<RegionView> parts;
    Repaired result;
    for (std::size_t f = 0; f < count; ++f) {
      parts.push_back(changes[f].empty() ? feature_regions(layer_, f) : RegionView(changes[f][0].regions));
      if (!changes[f].empty()) result.changed.push_back(std::move(changes[f][0].report));
    }
    result.features = join_features(parts).features;
    return result;
  }

 private:
  void look_at(std::uint32_t f, Array<Change>& change) const {
    const RegionView feature = feature_regions(layer_, f);
    if (feature.points.empty()) return;
    poll();
    if (checking::is_valid_feature({layer_, f})) return;
    Statistics statistics;
    PipelineResult resolved = run_pipeline(feature, nullptr, {Operation::unite, options_, control_}, statistics);
    FeatureRepair report = describe_repair(feature, resolved.regions);
    report.feature = f;
    change.push_back({std::move(resolved.charge), std::move(resolved.regions), std::move(report)});
  }

  const FeatureView& layer_;
  Control& control_;
  Options options_;
};

}  // namespace

Repaired repair(const FeatureView& features, const RepairOptions& options) {
  return public_call(options, features.regions.points.size(), [&](Control& control) {
    validate_features(features, 0);
    return Repair(features, control).run();
  });
}

}  // namespace oblast
