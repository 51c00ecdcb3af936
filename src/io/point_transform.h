// From one coordinate system to another.
#pragma once

#include <oblast/region_set.h>

#include <memory>
#include <span>
#include <string>

namespace oblast::io {

class PointTransform {
 public:
  /// Both systems as WKT; x is longitude or easting. Throws IoError if PROJ knows no way.
  PointTransform(const std::string& from_wkt, const std::string& to_wkt);
  ~PointTransform();
  PointTransform(PointTransform&&) noexcept;
  PointTransform& operator=(PointTransform&&) noexcept;

  /// A point for which there is no result becomes infinite.
  void apply(std::span<Point> points);
  const std::string& target_name() const { return target_name_; }

 private:
  struct Data;  // has GDAL types
  std::unique_ptr<Data> data_;
  std::string target_name_;
};

}  // namespace oblast::io
