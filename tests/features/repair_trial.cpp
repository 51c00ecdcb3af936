#include "features/repair_trial.h"

#include <oblast/repair.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "features/layers.h"
#include "generators/far.h"
#include "generators/random.h"
#include "repair/layers_of.h"
#include "verify/exact_sum.h"
#include "verify/rows.h"

namespace oblast::testing {
namespace {

/// The area of outer rings without that of holes, whatever their directions.
verify::Rational exact_area_of_rings(const RegionView& feature) {
  verify::Rational sum = 0;
  for (const PolygonView polygon : feature.polygons()) {
    for (std::size_t c = 0; c < polygon.contour_count(); ++c) {
      verify::Rational area = verify::exact_area_of(polygon.view().contours_between(c, c + 1));
      if ((area < 0) != (c > 0)) area = -area;
      sum += area;
    }
  }
  return sum;
}

using Keys = std::vector<FeatureKey>;

class RepairTrial {
 public:
  RepairTrial(const generators::Operands& operands, std::uint64_t seed, bool exact)
      : operands_(operands), layer_(random_layers(operands, seed).a), seed_(seed), exact_(exact) {
    generators::Random random(seed ^ 0x726570616972);
    threads_ = random.one_in(8);
    options_.threads = coverage_options_.threads = 1;
    if (random.one_in(2)) coverage_options_.overlaps = OverlapRule::largest;
    const double infinity = std::numeric_limits<double>::infinity();
    const double area = std::fabs(signed_area(unite(layer_.regions)));  // of slivers it may seem negative
    for (double* const bound : {&coverage_options_.gaps_below, &coverage_options_.slivers_below})
      if (random.one_in(2)) *bound = random.one_in(4) ? infinity : area * random.unit() / 8;
    for (double* const bound : {&coverage_options_.gaps_narrower, &coverage_options_.slivers_narrower})
      if (random.one_in(4)) *bound = random.one_in(4) ? infinity : random.unit();
  }

  std::optional<RepairFailure> run(RepairedTexts* texts) {
    try {
      const Repaired repaired = repair(layer_, options_);
      const RepairedCoverage coverage = repair_coverage(layer_, coverage_options_);
      if (texts) *texts = {texts_of(repaired.features), texts_of(coverage.features)};
      if (auto failure = look_at_features(repaired)) return failure;
      return look_at_coverage(coverage);
    } catch (const std::exception& e) {
      return RepairFailure{BrokenRepair::threw, "", e.what()};
    }
  }

 private:
  using Failure = std::optional<RepairFailure>;

  Failure look_at_features(const Repaired& repaired) const {
    const auto failure = [](BrokenRepair broken, std::string what) {
      return RepairFailure{broken, "repair", std::move(what)};
    };
    const FeatureSet& rows = repaired.features;
    if (rows.size() != layer_.feature_ends.size()) return failure(BrokenRepair::order, "rows are missing");
    for (std::uint32_t f = 0, next = 0; f < rows.size(); ++f) {
      const bool changed = next < repaired.changed.size() && repaired.changed[next].feature == f;
      if (changed && repaired.changed[next].faults.empty()) return failure(BrokenRepair::wrong, "changed for no fault");
      if (changed) ++next;
      const RegionView row = verify::regions_of(rows, f);
      if (auto what = fault_of_feature(row, f, changed)) return failure(what->broken, what->what);
    }
    const Repaired again = repair(rows, options_);
    if (again.features != rows || !again.changed.empty()) return failure(BrokenRepair::again, "repaired again");
    const FeatureSet canonical = canonical_rows(rows);
    const Repaired shuffled = repair(shuffled_within_rows(layer_, seed_ + 1), options_);
    if (canonical_rows(shuffled.features) != canonical)
      return failure(BrokenRepair::order, "bytes change with the order");
    if (repair_with_squares(canonical.size()) != canonical)
      return failure(BrokenRepair::far, "bytes change with squares elsewhere");
    if (threads_) {
      RepairOptions two = options_;
      two.threads = 2;
      const Repaired parallel = repair(layer_, two);
      if (parallel.features != rows || parallel.changed != repaired.changed)
        return failure(BrokenRepair::threads, "bytes change with the threads");
    }
    if (!exact_) return {};
    const auto keys = [](const auto& i, const auto&) {
      Keys of_place;
      for (const std::uint32_t f : i) of_place.push_back({f, no_feature});
      return of_place;
    };
    return against(canonical, keys, "repair");
  }

  Failure fault_of_feature(const RegionView& row, std::uint32_t f, bool changed) const {
    if (changed) {
      const auto fault = row.points.empty() ? std::nullopt : verify::check_result(row);
      if (fault) return RepairFailure{BrokenRepair::unverified, "repair", fault->what};
    } else {
      const RegionSet resolved = unite(row);
      if (exact_area_of_rings(row) != verify::exact_area_of(resolved))
        return RepairFailure{BrokenRepair::area, "repair", "a feature was kept that means another region"};
      const RegionView before = verify::regions_of(layer_, f);
      if (!std::equal(row.points.begin(), row.points.end(), before.points.begin(), before.points.end()))
        return RepairFailure{BrokenRepair::order, "repair", "a feature that was kept has other vertices"};
    }
    return {};
  }

  FeatureSet repair_with_squares(std::size_t rows) const {
    const Layer all = with_rows(layer_, generators::far_squares(operands_, seed_).a);
    const Repaired repaired = repair(all, options_);
    return first_rows(repaired.features, rows);
  }

  static FeatureSet first_rows(const FeatureSet& all, std::size_t rows) {
    if (rows == 0) return {};
    const FeatureView first{all.regions, std::span(all.feature_ends).first(rows)};
    return canonical_rows(first);
  }

  Failure against(const FeatureSet& rows, const verify::KeysOfPlace& keys, const char* operation) const {
    const auto fault = verify::check_rows_against(layer_, Layer(), keys, rows, rows.keys);
    if (fault) return RepairFailure{BrokenRepair::wrong, operation, fault->what};
    return {};
  }

  Failure look_at_coverage(const RepairedCoverage& repaired) const {
    const auto failure = [](BrokenRepair broken, std::string what) {
      return RepairFailure{broken, "repair_coverage", std::move(what)};
    };
    const FeatureSet canonical = canonical_rows(repaired.features);
    if (const auto fault = verify::check_rows(canonical)) return failure(BrokenRepair::unverified, fault->what);
    if (!depth_is_one(canonical)) return failure(BrokenRepair::unverified, "features overlap");
    if (canonical.regions.points.size() > repaired.features.regions.points.size())
      return failure(BrokenRepair::area, "a row lacks vertices");
    const RepairedCoverage again = repair_coverage(repaired.features, coverage_options_);
    if (again.features != repaired.features || !again.changes.empty() || !again.changed.empty())
      return failure(BrokenRepair::again, "repaired again");
    const RepairedCoverage shuffled = repair_coverage(shuffled_within_rows(layer_, seed_ + 1), coverage_options_);
    if (canonical_rows(shuffled.features) != canonical || shuffled.changes != repaired.changes)
      return failure(BrokenRepair::order, "bytes change with the order");
    if (threads_) {
      CoverageRepairOptions two = coverage_options_;
      two.threads = 2;
      const RepairedCoverage parallel = repair_coverage(layer_, two);
      if (parallel.features != repaired.features || parallel.changes != repaired.changes)
        return failure(BrokenRepair::threads, "bytes change with the threads");
    }
    return look_at_overlaps_only();
  }

  static bool depth_is_one(const FeatureSet& rows) {
    const FeatureSet depths = depth(rows);
    return std::all_of(depths.keys.begin(), depths.keys.end(), [](const FeatureKey& key) { return key.a == 1; });
  }

  /// Without gaps and slivers, what lies elsewhere changes nothing, and each place has its key.
  Failure look_at_overlaps_only() const {
    CoverageRepairOptions options;
    options.threads = 1;
    const RepairedCoverage first = repair_coverage(layer_, options);
    const FeatureSet canonical = canonical_rows(first.features);
    const Layer all = with_rows(layer_, generators::far_squares(operands_, seed_).a);
    const RepairedCoverage more = repair_coverage(all, options);
    if (first_rows(more.features, canonical.size()) != canonical)
      return RepairFailure{BrokenRepair::far, "repair_coverage", "bytes change with squares elsewhere"};
    if (!exact_) return {};
    const auto keys = [](const auto& i, const auto&) { return i.empty() ? Keys{} : Keys{{i[0], no_feature}}; };
    return against(canonical, keys, "repair_coverage");
  }

  const generators::Operands& operands_;
  Layer layer_;
  std::uint64_t seed_;
  bool exact_;
  RepairOptions options_;
  CoverageRepairOptions coverage_options_;
  bool threads_ = false;
};

}  // namespace

const char* to_text(BrokenRepair broken) {
  constexpr const char* names[] = {"unverified", "area", "again", "order", "far", "threads", "wrong", "exception"};
  return names[static_cast<int>(broken)];
}

std::optional<RepairFailure> run_repair_trial(const generators::Operands& operands, std::uint64_t seed, bool exact,
                                              RepairedTexts* texts) {
  return RepairTrial(operands, seed, exact).run(texts);
}

}  // namespace oblast::testing
