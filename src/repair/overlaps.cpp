// Step 1 of repair_coverage: what several features cover goes to one of them.
#include <algorithm>

#include "base/parallel.h"
#include "repair/exact_sum.h"
#include "repair/owned_pieces.h"

namespace oblast::internal::repairing {
namespace {

/// Calls visit(row, polygon) for each polygon of the rows.
template <class Visit>
void for_pieces(const Partition& partition, const Visit& visit) {
  for (std::uint32_t row = 0, polygon = 0; row < partition.rows.size(); ++row)
    for (; polygon < partition.rows.feature_ends[row]; ++polygon) visit(row, polygon);
}

/// Twice the area of each feature: that of its pieces.
Array<ExactSum> areas_of_features(const Partition& partition, std::size_t features) {
  const RegionView pieces = partition.rows.regions;
  Array<ExactSum> of_piece(pieces.polygon_count()), of_feature(features);
  for_ranges(of_piece.size(), grain(of_piece.size(), pieces.points.size()), [&](std::size_t p, std::size_t end) {
    for (; p < end; ++p) of_piece[p] = twice_area(pieces.polygon(p));
  });
  for_pieces(partition, [&](std::uint32_t row, std::uint32_t polygon) {
    for (const FeatureSource& source : partition.sources_of(row)) of_feature[source.feature].add(of_piece[polygon]);
  });
  return of_feature;
}

/// By row of the partition: the feature that has it now.
Array<std::uint32_t> owners_of_rows(const Partition& partition, std::size_t features, OverlapRule rule) {
  Array<ExactSum> area;
  const bool overlaps = partition.sources.size() > partition.rows.size();
  if (rule == OverlapRule::largest && overlaps) area = areas_of_features(partition, features);
  const auto is_larger = [&](std::uint32_t f, std::uint32_t g) {
    ExactSum difference = area[f];
    difference.subtract(area[g]);
    return difference.sign() > 0;
  };
  Array<std::uint32_t> owners;
  for (std::size_t row = 0; row < partition.rows.size(); ++row) {
    const auto sources = partition.sources_of(row);
    std::uint32_t owner = sources[0].feature;
    for (const FeatureSource& source : sources.subspan(1))
      if (rule == OverlapRule::largest && is_larger(source.feature, owner)) owner = source.feature;
    owners.push_back(owner);
  }
  return owners;
}

}  // namespace

OwnedPieces share_out_overlaps(const FeatureView& layer, OverlapRule rule, std::vector<CoverageRepair>& changes) {
  Partition partition = oblast::partition({&layer, 1});
  const Array<std::uint32_t> owners = owners_of_rows(partition, layer.feature_count(), rule);
  const RegionView regions = partition.rows.regions;
  OwnedPieces pieces{Charge(bytes_of(regions)), {}, {}};
  for_pieces(partition, [&](std::uint32_t row, std::uint32_t polygon) {
    pieces.owner.push_back(owners[row]);
    const auto sources = partition.sources_of(row);
    if (sources.size() == 1) return;
    std::vector<std::uint32_t> from;
    for (const FeatureSource& source : sources)
      if (source.feature != owners[row]) from.push_back(source.feature);
    changes.push_back(change_of(CoverageChange::overlap, std::move(from), owners[row], regions.polygon(polygon)));
  });
  pieces.regions = std::move(partition.rows.regions);
  return pieces;
}

FeatureSet unite_by_owner(const OwnedPieces& pieces, std::size_t features) {
  FeatureSet rows = dissolve({pieces.regions, {}}, pieces.owner);
  for (auto f = static_cast<std::uint32_t>(rows.size()); f < features; ++f) {
    rows.feature_ends.push_back(static_cast<std::uint32_t>(rows.regions.polygon_ends.size()));
    rows.keys.push_back({f, no_feature});
  }
  return rows;
}

}  // namespace oblast::internal::repairing
