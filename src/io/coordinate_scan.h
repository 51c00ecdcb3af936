// Looks for coordinates that cannot be meant as they are: only where x is longitude and y is latitude.
#pragma once

#include <oblast/region_set.h>

#include <algorithm>
#include <limits>
#include <span>
#include <string>

#include "io/layer.h"

namespace oblast::io {

/// The scan of one file. Use: add_ring for each ring as it is in the file, end_polygon after the rings of each polygon;
/// at the end report_to.
class CoordinateScan {
 public:
  /// Does nothing unless the system is geographic.
  explicit CoordinateScan(const std::string& crs_wkt);

  void add_ring(std::span<const Point> ring) {
    if (quarter_ > 0) scan(ring);
  }
  void end_polygon();
  /// Adds what the scan of another part of the same file has seen.
  void add(const CoordinateScan& other);
  void report_to(ReadReport& report) const;

 private:
  struct Range {
    double least = std::numeric_limits<double>::infinity(), most = -std::numeric_limits<double>::infinity();
    void add(double value) {
      least = std::min(least, value);
      most = std::max(most, value);
    }
    double middle() const { return (least + most) / 2; }
  };
  void scan(std::span<const Point> ring);
  bool looks_swapped() const;

  double quarter_ = 0;     // of a turn, in the unit of the coordinates; 0: not geographic
  Range x_, y_;            // of the file
  Range area_x_, area_y_;  // where the system is used; empty if it is not known
  std::uint64_t beyond_pole_ = 0, across_ = 0;
  bool across_now_ = false;  // of this polygon
};

}  // namespace oblast::io
