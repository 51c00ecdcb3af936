// Layers: features (rows) with regions, overlaid row by row. The rows of a result name the rows they come from, so the
// caller joins the attributes.
//
//   points, contour_ends, polygon_ends   as in region_set.h
//   feature_ends   2, 3, 6               feature f is polygons [feature_ends[f-1], feature_ends[f])
//
// All polygons of all layers go into one arrangement, which is noded once. Borders that rows of the result share are
// the same vertices, bit for bit, and edges of different rows are identical or meet at their ends only (promise G8).
#pragma once

#include <oblast/export.h>
#include <oblast/options.h>
#include <oblast/region_set.h>

#include <cstdint>
#include <span>
#include <vector>

namespace oblast {

/// A layer in a caller's arrays, viewed without copying them. The region of a feature is the union of its polygons,
/// each the even-odd of its own rings. A feature may have no polygons. With `feature_ends` empty every polygon is a
/// feature.
struct FeatureView {
  RegionView regions;
  std::span<const std::uint32_t> feature_ends;  ///< not decreasing; the last one is the number of polygons

  std::size_t feature_count() const { return feature_ends.empty() ? regions.polygon_count() : feature_ends.size(); }
  std::uint32_t feature_begin(std::size_t f) const {
    if (feature_ends.empty()) return static_cast<std::uint32_t>(f);
    return f == 0 ? 0 : feature_ends[f - 1];
  }
  std::uint32_t feature_end(std::size_t f) const {
    return feature_ends.empty() ? static_cast<std::uint32_t>(f + 1) : feature_ends[f];
  }
};

/// In place of a row that there is not.
inline constexpr std::uint32_t no_feature = 0xffffffff;

/// What a row of a result is made of. Each function says what it puts in.
struct FeatureKey {
  std::uint32_t a = no_feature;
  std::uint32_t b = no_feature;

  friend auto operator<=>(const FeatureKey&, const FeatureKey&) = default;
};

/// Owned features. As a result: feature f has the key keys[f], the keys ascend, and the polygons of each feature are
/// canonical as those of a region set. Features may overlap where the function says so; their edges never cross.
struct FeatureSet {
  RegionSet regions;
  std::vector<std::uint32_t> feature_ends;
  std::vector<FeatureKey> keys;

  std::size_t size() const { return feature_ends.size(); }
  operator FeatureView() const& { return {regions, feature_ends}; }
  operator FeatureView() const&& = delete;

  friend bool operator==(const FeatureSet&, const FeatureSet&) = default;
};

/// Which rows an overlay of two layers has, and where each of them is. I are the features of A that cover a place, J
/// those of B.
enum class FeatureOperation {
  intersection,          ///< (i, j) for every i in I and j in J
  identity,              ///< those, and (i, none) where J is empty
  unite,                 ///< those, and (none, j) where I is empty
  difference,            ///< (i, none) where J is empty
  symmetric_difference,  ///< (i, none) where J is empty, (none, j) where I is empty
};

/// Overlays two layers. The key of a row is (feature of A or no_feature, feature of B or no_feature). Rows of one layer
/// that overlap stay rows that overlap. `options.fill_a` and `fill_b` must read polygons one by one (`polygons`, or
/// `at_least(k)`: the places that at least k polygons of the same feature cover). There is one engine for rows, so
/// `options.engine` must be the default. Throws Error: not_finite, out_of_domain, too_large, bad_offsets, bad_option,
/// cancelled, memory_limit. Cost: O((n + k) log n + r), n edges, k intersections, r the size of the result.
OBLAST_API FeatureSet overlay_features(const FeatureView& a, const FeatureView& b, FeatureOperation operation,
                                       const Options& options = {});

/// Unites features by group: row g of the result is the union of all features f with groups[f] == g, and its key is
/// (g, no_feature). There is a row for every number up to the largest one in `groups`; those of groups without a region
/// are empty. Groups that overlap stay rows that overlap. REQUIRES, else Error(bad_option): one group for each feature.
/// Other errors and cost as overlay_features.
OBLAST_API FeatureSet dissolve(const FeatureView& features, std::span<const std::uint32_t> groups,
                               const Options& options = {});

/// How many features cover a place: the row with the key (d, no_feature) is where exactly d features do, d from 1 on.
/// Rows do not overlap. With `groups` (one for each feature) the number of different groups counts, not of features: if
/// features are fires and groups are days, on how many days a place burnt. Errors and cost as overlay_features.
OBLAST_API FeatureSet depth(const FeatureView& features, std::span<const std::uint32_t> groups = {},
                            const Options& options = {});

/// A row of one of several layers.
struct FeatureSource {
  std::uint32_t layer;
  std::uint32_t feature;

  friend auto operator<=>(const FeatureSource&, const FeatureSource&) = default;
};

/// Rows that do not overlap, each with all the features that cover it.
struct Partition {
  FeatureSet rows;                         ///< row r has the key (r, no_feature)
  std::vector<std::uint32_t> source_ends;  ///< by row: past its last source
  std::vector<FeatureSource> sources;      ///< of each row in order; rows are in the order of these lists

  std::span<const FeatureSource> sources_of(std::size_t row) const {
    const std::uint32_t begin = row == 0 ? 0 : source_ends[row - 1];
    return std::span(sources).subspan(begin, source_ends[row] - begin);
  }
  friend bool operator==(const Partition&, const Partition&) = default;
};

/// Cuts the plane by all layers at once: a row for every set of features that cover a place. `options.fill_a` is the
/// rule of all layers. Errors and cost as overlay_features.
OBLAST_API Partition partition(std::span<const FeatureView> layers, const Options& options = {});

}  // namespace oblast
