// The coordinate system of EWKT and EWKB, by the number that PostGIS gives it.
#pragma once

#include <optional>
#include <string>

namespace oblast::io {

/// The one SRID of all geometries of a text.
class CommonSrid {
 public:
  /// Messages call the text `name`.
  explicit CommonSrid(const std::string& name) : name_(name) {}

  /// To be called for each geometry; 0: it names none. True for the first. Throws IoError, with the place, if it is not
  /// that of the first, or if PROJ does not know it.
  bool add(unsigned srid, const std::string& place);
  /// The system as WKT; empty for 0.
  const std::string& wkt() const { return wkt_; }

 private:
  std::string name_;
  std::optional<unsigned> srid_;
  std::string wkt_;
};

}  // namespace oblast::io
