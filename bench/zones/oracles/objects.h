// The objects of a file of shapes, and their zones by oblast.
#pragma once

#include <oblast/zones.h>

#include <string>

#include "buffers/shape_file.h"

namespace zones {

/// Objects are polygons, lines and points, in this order, in a frame: their box with a margin of a tenth.
class Objects {
 public:
  explicit Objects(const buffers::Shapes& shapes);
  explicit Objects(const std::string& path) : Objects(buffers::read_shapes(path)) {}

  oblast::ShapeFeatures view() const { return {{regions_, {line_points_, line_ends_}, points_}, {}, {}, {}}; }
  const oblast::RegionSet& frame() const { return frame_; }
  const std::vector<oblast::Point>& points() const { return points_; }
  std::size_t size() const { return regions_.polygon_ends.size() + line_ends_.size() + points_.size(); }
  /// Tolerance 0: the default.
  oblast::FeatureSet zones(double tolerance, oblast::ZoneStatistics& statistics) const;

 private:
  oblast::RegionSet regions_, frame_;
  std::vector<oblast::Point> line_points_, points_;
  std::vector<std::uint32_t> line_ends_;
};

}  // namespace zones
