// Coordinate systems, given as WKT. Heights are left out of every system: Z is not read.
#pragma once

#include <set>
#include <string>

namespace oblast::io {

/// The system that a user names: "EPSG:4326", the name of a file with WKT, WKT, or a PROJ string. Throws IoError if it
/// is none.
std::string crs_from_text(const std::string& text);

/// True if both texts name the same coordinate system, or if one of them is empty (a file without a coordinate system
/// matches any). x is always longitude or easting, and y latitude or northing. So the order of axes in a text does not
/// matter: GeoJSON's CRS84 is EPSG:4326. Heights do not matter either: EPSG:4979 is EPSG:4326.
bool same_crs(const std::string& wkt_a, const std::string& wkt_b);

/// The coordinate system that the files of one operand share.
class CommonCrs {
 public:
  /// Adds the system of `file` (empty: none). Throws IoError, which names both files, if it differs from an earlier
  /// one, or if only one of them has a system.
  void add(const std::string& wkt, const std::string& file);
  /// Empty if no file names a system.
  const std::string& wkt() const { return wkt_; }

 private:
  void refuse_mixture() const;

  std::string wkt_;
  std::string file_;
  std::string file_without_;        ///< the first file that names no system
  std::set<std::string> accepted_;  ///< texts already known to be the same: a comparison can take a tenth of a second
};

/// Throws IoError, which names both operands, if their coordinate systems differ, or if only one of them has one. A
/// label is how messages call an operand: "A (a.gpkg)".
void require_same_crs(const std::string& label_a, const std::string& wkt_a, const std::string& label_b,
                      const std::string& wkt_b);

/// The name for messages: "WGS 84 (EPSG:4326)"; "none" for an empty text.
std::string crs_name(const std::string& wkt);

/// What an option accepts for the system: "EPSG:4326"; the name if it has no code.
std::string crs_word(const std::string& wkt);

}  // namespace oblast::io
