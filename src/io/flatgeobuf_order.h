// Restores the order in which the polygons of a FlatGeobuf file were written.
//
// FlatGeobuf's spatial index sorts features along a Hilbert curve, so the file does not keep the order of the writer.
// Our files have the attribute `polygon`, the number of each polygon. If its values are a permutation of 0 to n-1,
// reading restores that order, and a result stays canonical (promise G3).
#pragma once

#include <cstdint>
#include <vector>

#include "io/layer.h"

class OGRFeature;

namespace oblast::io {

class FlatgeobufOrder {
 public:
  /// `field` is the index of the attribute `polygon`, or -1: then nothing is done.
  FlatgeobufOrder(int field, Layer& layer);
  /// To be called after each feature that was appended to the layer.
  void add(const OGRFeature& feature);
  /// Sorts what was appended since construction. Cost: linear.
  void restore();

 private:
  bool is_permutation() const;

  int field_;
  Layer& layer_;
  std::size_t first_polygon_;
  std::size_t first_feature_;
  std::vector<std::int64_t> number_;  // by polygon, in the file's order
};

}  // namespace oblast::io
