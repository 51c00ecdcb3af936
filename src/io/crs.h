// Compares coordinate systems, given as WKT.
#pragma once

#include <set>
#include <string>

namespace oblast::io {

/// True if both texts name the same coordinate system, or if one of them is empty (a file without a coordinate system
/// matches any). x is always longitude or easting, and y latitude or northing. So the order of axes in a text does not
/// matter: GeoJSON's CRS84 is EPSG:4326.
bool same_crs(const std::string& wkt_a, const std::string& wkt_b);

/// The coordinate system that the files of one operand share.
class CommonCrs {
 public:
  /// Adds the system of `file` (empty: none). Throws IoError, which names both files, if it differs from an earlier
  /// one.
  void add(const std::string& wkt, const std::string& file);
  /// Empty if no file names a system.
  const std::string& wkt() const { return wkt_; }

 private:
  std::string wkt_;
  std::string file_;
  std::set<std::string> accepted_;  ///< texts already known to be the same: a comparison can take a tenth of a second
};

/// The name for messages: "WGS 84 (EPSG:4326)"; "none" for an empty text.
std::string crs_name(const std::string& wkt);

}  // namespace oblast::io
