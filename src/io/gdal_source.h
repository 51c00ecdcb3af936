// A vector file opened with GDAL. Only for use inside src/io, because it has GDAL types.
#pragma once

#include <ogrsf_frmts.h>

#include <memory>
#include <string>
#include <vector>

#include "io/gdal_session.h"
#include "io/source.h"

namespace oblast::io {

class GdalSource {
 public:
  /// Opens a layer of a file; messages call it `name`. Throws IoError if GDAL cannot open the file, if it has no such
  /// layer, or if it has several and none is named.
  GdalSource(const Source& source, const std::string& name);

  GdalMessages& messages() { return messages_; }
  bool is_driver(const char* name) const;
  OGRLayer& layer() { return *layer_; }
  /// What the file has besides, and what is not read.
  const std::vector<std::string>& notes() const { return notes_; }

  /// Reads only the features for which a condition on their attributes holds; an empty one is no condition. Throws
  /// IoError with GDAL's message if the condition is faulty.
  void set_condition(const std::string& where);

 private:
  GdalMessages messages_;
  // Without this, GDAL lists the folder again for each file: quadratic in the number of files.
  ThreadOption no_listing_{"GDAL_DISABLE_READDIR_ON_OPEN", "TRUE"};
  ThreadOption no_grouping_{"OGR_ORGANIZE_POLYGONS", "SKIP"};
  ThreadOption no_repair_{"SHAPE_RESTORE_SHX", "NO"};
  ThreadOption no_comparing_{"USE_OSR_FIND_MATCHES", "NO"};
  ThreadOption no_size_limit_{"OGR_GEOJSON_MAX_OBJ_SIZE", "0"};
  std::unique_ptr<GDALDataset> dataset_;
  std::string name_;
  OGRLayer* layer_ = nullptr;
  std::vector<std::string> notes_;
};

}  // namespace oblast::io
