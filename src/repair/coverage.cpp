// Features made a coverage, step by step.
#include <oblast/repair.h>

#include <cmath>
#include <string>

#include "base/parallel.h"
#include "base/public_call.h"
#include "base/stage_shares.h"
#include "features/validate_features.h"
#include "regions/join_features.h"
#include "repair/feature_regions.h"
#include "repair/owned_pieces.h"
#include "repair/same_region.h"

namespace oblast {
using namespace internal;
using namespace internal::repairing;
namespace {

void check_bound(double bound, const char* name) {
  if (bound >= 0) return;
  throw Error(ErrorCode::bad_option,
              std::string(name) + (std::isnan(bound) ? " is not a number" : " is negative") + "; it must be 0 or more");
}

FeatureSet repaired_rows(const FeatureView& layer, const CoverageRepairOptions& options, RepairedCoverage& result) {
  OwnedPieces pieces;
  {
    const Share share(coverage_arrangement_share);
    pieces = share_out_overlaps(layer, options.overlaps, result.changes);  // 1
  }
  {
    const Share share(coverage_gaps_share);
    result.gaps_left = close_gaps(pieces, {options.gaps_below, options.gaps_narrower}, result.changes);  // 2
  }
  FeatureSet rows;
  {
    const Share share(coverage_union_share);
    rows = unite_by_owner(pieces, layer.feature_count());
  }
  move_slivers(rows, {options.slivers_below, options.slivers_narrower}, result.changes);  // 3
  return rows;
}

/// Features that are what they were come back as they were.
void keep_unchanged(const FeatureView& layer, const FeatureSet& rows, RepairedCoverage& result) {
  const std::size_t count = layer.feature_count();
  Array<RegionView> parts(count);
  Array<std::uint8_t> same(count);
  for_ranges(count, grain(count, layer.regions.points.size()), [&](std::size_t f, std::size_t end) {
    for (; f < end; ++f) {
      const RegionView before = feature_regions(layer, f), now = feature_regions(rows, f);
      same[f] = is_same_region(before, now, MoreVertices::refused);
      parts[f] = same[f] ? before : now;
    }
  });
  for (std::uint32_t f = 0; f < count; ++f)
    if (!same[f]) result.changed.push_back(f);
  result.features = join_features(parts).features;
}

}  // namespace

RepairedCoverage repair_coverage(const FeatureView& features, const CoverageRepairOptions& options) {
  check_enumerator(options.overlaps, OverlapRule::largest, "OverlapRule");
  check_bound(options.gaps_below, "gaps_below");
  check_bound(options.gaps_narrower, "gaps_narrower");
  check_bound(options.slivers_below, "slivers_below");
  check_bound(options.slivers_narrower, "slivers_narrower");
  return public_call(options, features.regions.points.size(), [&](Control&) {
    validate_features(features, 0);
    RepairedCoverage result;
    const FeatureSet rows = repaired_rows(features, options, result);
    const Charge charge(bytes_of(rows.regions));
    keep_unchanged(features, rows, result);
    return result;
  });
}

}  // namespace oblast
