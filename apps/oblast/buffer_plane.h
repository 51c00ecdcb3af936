// Where zones are computed: in the coordinates of the layer, or in those of another system and back.
#pragma once

#include <oblast/buffer.h>

#include <optional>
#include <string>
#include <vector>

#include "io/rows.h"
#include "io/working_crs.h"

namespace oblast::app {

/// The smallest box around all vertices and points; nothing if there are none.
std::optional<Box> extent_of(const io::Layer& layer);

class BufferPlane {
 public:
  /// `crs_wkt`: compute in this system. Empty: in that of the layer. The rows must outlive the plane. Throws IoError
  /// for a place that cannot be transformed.
  BufferPlane(const io::Rows& rows, const std::string& crs_wkt);

  ShapeFeatures shapes() const;
  const io::CoordinateUnit& unit() const { return unit_; }
  bool is_other() const { return !wkt_.empty(); }
  /// The system of the computation; empty: none.
  const std::string& crs() const { return is_other() ? wkt_ : rows_.layer.crs_wkt; }

  /// Takes a zone back to the system of the layer. What rounding makes cross is resolved: in the union of all rows, or
  /// in each row. Longitudes may go beyond 180 degrees where a zone crosses the date line. Throws IoError if a zone
  /// holds a pole.
  RegionSet back(RegionSet zone, const CallOptions& options) const;
  FeatureSet back(FeatureSet zones, const CallOptions& options) const;
  /// The same of rows that do not overlap, which then do not overlap either: all are resolved together. Places that
  /// several rows would cover go to the first.
  FeatureSet coverage_back(FeatureSet zones, const CallOptions& options) const;

 private:
  void move_back(std::vector<Point>& points) const;
  void check_turns(const RegionView& regions) const;

  const io::Rows& rows_;
  std::vector<std::uint32_t> region_rows_;
  std::string wkt_;  // empty: that of the layer
  io::CoordinateUnit unit_;
  double middle_ = 0, full_turn_ = 0;  // of the longitudes of the layer
  struct Moved {
    std::vector<Point> regions, lines, points;
  } moved_;
};

}  // namespace oblast::app
