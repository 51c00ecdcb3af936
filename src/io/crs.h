// Coordinate systems by their WKT: are two the same, and which of a layer's files disagree.
#pragma once

#include <set>
#include <string>

namespace oblast::io {

/// True when both texts name the same coordinate system, or when one of them is empty (a file
/// without one goes with any). Coordinates are always x = longitude or easting, y = latitude or
/// northing, so the order of axes a text declares does not matter: GeoJSON's CRS84 is EPSG:4326.
bool same_crs(const std::string& wkt_a, const std::string& wkt_b);

/// The coordinate system that the files of one operand share.
class CommonCrs {
 public:
  /// `file` has this system (empty: none). Throws IoError naming both files when it contradicts an earlier one.
  void add(const std::string& wkt, const std::string& file);
  /// Empty when no file named one.
  const std::string& wkt() const { return wkt_; }

 private:
  std::string wkt_;
  std::string file_;
  std::set<std::string> accepted_;  ///< texts found to be the same: comparing can take a tenth of a second
};

/// The name a person knows: "WGS 84 (EPSG:4326)"; "none" for an empty text.
std::string crs_name(const std::string& wkt);

}  // namespace oblast::io
