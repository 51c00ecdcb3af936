// A file that GDAL writes, with one new layer. Only for use inside src/io, because it has GDAL types.
#pragma once

#include <cpl_string.h>

#include <memory>
#include <string>

#include "io/gdal_output.h"

namespace oblast::io {

/// What is written, and how messages call the file.
struct GdalLayer {
  const std::string& path;
  std::string driver;
  std::string layer;
  const std::string& crs_wkt;
  const std::string& name;
};

class GdalOutputFile {
 public:
  /// Creates the file. If there is a GeoPackage at `path`, adds the layer to it, in place of one of the same name.
  /// Throws IoError.
  GdalOutputFile(const GdalLayer& what, OGRwkbGeometryType type, CPLStringList options);

  OGRLayer& layer() { return *layer_; }
  const Check& check() const { return check_; }
  /// To be called after the last column.
  void begin_features();
  /// Completes the file. Throws IoError.
  void close();

 private:
  void open(const GdalLayer& what);

  GdalMessages messages_;
  ThreadOption no_listing_{"GDAL_DISABLE_READDIR_ON_OPEN", "TRUE"};
  // The file is renamed only after it is complete, and flushed to the disk before.
  ThreadOption no_sync_{"OGR_SQLITE_SYNCHRONOUS", "OFF"};
  // The rings have the right directions already. GDAL would compare every ring of a polygon with every other.
  ThreadOption no_rewind_{"SHAPE_REWIND_ON_WRITE", "NO"};
  ThreadOption date_;
  Check check_;
  Dataset dataset_;
  OGRLayer* layer_ = nullptr;
  bool transaction_ = false;
};

/// The layer, opened to be read back: buffered data can be lost when a file is closed on a full disk, and not every
/// driver reports this.
class WrittenLayer {
 public:
  explicit WrittenLayer(const GdalLayer& what);
  OGRLayer& layer() { return *layer_; }
  const Check& check() const { return check_; }

 private:
  GdalMessages messages_;
  ThreadOption no_listing_{"GDAL_DISABLE_READDIR_ON_OPEN", "TRUE"};
  ThreadOption no_grouping_{"OGR_ORGANIZE_POLYGONS", "SKIP"};
  ThreadOption no_comparing_{"USE_OSR_FIND_MATCHES", "NO"};  // of the .prj with all systems there are
  Check check_;
  Dataset dataset_;
  OGRLayer* layer_ = nullptr;
};

/// Counts vertices that a file has in another place than they were given, in the order of the file. Formats whose
/// drivers print numbers have fewer digits than a double.
class ChangedVertices {
 public:
  /// `driver` decides whether there is anything to compare.
  ChangedVertices(const std::string& driver, const RegionView& given)
      : compares_(driver == "LIBKML" || driver == "GML"), given_(given) {}
  void add(const OGRGeometry* geometry);
  /// A line that says so; empty: no vertex changed.
  std::string note() const;

 private:
  void add_polygon(const OGRPolygon& polygon);
  bool compares_;
  const RegionView& given_;
  std::size_t next_ = 0;
  std::uint64_t changed_ = 0;
};

}  // namespace oblast::io
