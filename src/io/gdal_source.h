// A vector file opened with GDAL. Only for use inside src/io, because it has GDAL types.
#pragma once

#include <ogrsf_frmts.h>

#include <memory>
#include <string>
#include <vector>

#include "io/gdal_session.h"

namespace oblast::io {

class GdalSource {
 public:
  /// Throws IoError if GDAL cannot open the file.
  explicit GdalSource(const std::string& path);

  GdalMessages& messages() { return messages_; }
  /// The layers that have geometry, and how messages call each: the path, with the layer's name if there are several.
  struct Entry {
    OGRLayer* layer;
    std::string name;
  };
  const std::vector<Entry>& layers() const { return layers_; }

 private:
  GdalMessages messages_;
  // Without this, GDAL lists the folder again for each file: quadratic in the number of files.
  ThreadOption no_listing_{"GDAL_DISABLE_READDIR_ON_OPEN", "TRUE"};
  ThreadOption no_grouping_{"OGR_ORGANIZE_POLYGONS", "SKIP"};
  ThreadOption no_repair_{"SHAPE_RESTORE_SHX", "NO"};
  ThreadOption no_comparing_{"USE_OSR_FIND_MATCHES", "NO"};
  ThreadOption no_size_limit_{"OGR_GEOJSON_MAX_OBJ_SIZE", "0"};
  std::unique_ptr<GDALDataset> dataset_;
  std::vector<Entry> layers_;
};

/// Reads only the features for which a condition on their attributes holds; an empty one is no condition. Throws
/// IoError with GDAL's message if the condition is faulty.
void set_condition(const GdalSource::Entry& entry, const std::string& where, GdalMessages& messages);

}  // namespace oblast::io
