// The edges of all features of a layer in one array, and who has a vertex at a point.
#pragma once

#include <oblast/check_features.h>

#include <cstdint>
#include <span>

#include "base/call_memory.h"
#include "noding/strands.h"

namespace oblast::internal::checking {

/// Each contour with three vertices or more is a closed strand of the group of its feature. Repeated vertices are left
/// out.
class LayerEdges {
 public:
  /// Cost: linear.
  explicit LayerEdges(const FeatureView& features);

  const noding::Strands& strands() const { return strands_; }
  const Point* points() const { return strands_.points.data(); }
  FeaturePlace place(std::uint32_t index) const;
  std::uint32_t feature_of(std::uint32_t index) const { return feature_[strands_.strand_of(index)]; }
  std::uint32_t before(std::uint32_t index) const {
    const std::size_t strand = strands_.strand_of(index);
    return index == strands_.begin(strand) ? strands_.ends[strand] - 2 : index - 1;
  }

  /// Prepares at(). Cost: O(n log n), on all cores.
  void sort();
  /// The vertices at a point, ascending. REQUIRES: sort().
  std::span<const std::uint32_t> at(const Point& p) const;

 private:
  noding::Strands strands_;
  Array<std::uint32_t> vertex_;   ///< by point: the vertex in its contour
  Array<std::uint32_t> contour_;  ///< by strand
  Array<std::uint32_t> feature_;  ///< by strand
  Array<std::uint32_t> order_;    ///< vertices by point
};

}  // namespace oblast::internal::checking
