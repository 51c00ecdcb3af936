// The checks of a result with several rows: promise G8, and whether each row is where its key says.
#pragma once

#include <oblast/features.h>

#include <functional>
#include <vector>

#include "verify/verify.h"

namespace oblast::verify {

/// Proves of a layer's rows, exactly:
/// - feature_ends are in order; each row is a closed and canonical region set (check_result);
/// - edges of different rows are identical or meet at common end points only. So no vertex on a border of one row is
///   missing in its neighbour.
/// Polygons, contours and vertices of the fault are counted through all rows. Cost: O(n log n).
std::optional<Fault> check_rows(const FeatureView& rows, ContourConvention convention = ContourConvention::ogc);

/// The rows of the result that a place belongs to, as their keys, ascending; `i` and `j` are the features of the first
/// and of the second layer that cover the place, ascending.
using KeysOfPlace =
    std::function<std::vector<FeatureKey>(const std::vector<std::uint32_t>& i, const std::vector<std::uint32_t>& j)>;

/// The table of keys of the operations.
std::vector<FeatureKey> keys_of_place(FeatureOperation operation, const std::vector<std::uint32_t>& i,
                                      const std::vector<std::uint32_t>& j);

/// Whether each row is where its key says: places where rows are wrong must lie within the bound of an input edge, and
/// be no larger than the bound times the length of all edges. The bound is `bound_ulps` units in the last place of the
/// largest coordinate. REQUIRES: check_rows found no fault; b may have no features. Cost: O(n^2) trapezoids of exact
/// numbers; made for less than about 100 edges.
std::optional<Fault> check_rows_against(const FeatureView& a, const FeatureView& b, const KeysOfPlace& keys,
                                        const FeatureView& rows, const std::vector<FeatureKey>& row_keys,
                                        double bound_ulps = 4);

/// The polygons of one feature.
RegionView regions_of(const FeatureView& layer, std::size_t feature);

}  // namespace oblast::verify
