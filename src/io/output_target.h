// Where a result goes: a file, or a layer of a GeoPackage.
#pragma once

#include <string>
#include <vector>

#include "io/layer.h"

namespace oblast::io {

struct OutputTarget {
  std::string path;   ///< `-` is standard output
  std::string layer;  ///< of GeoPackage: the name that was given; empty: none was

  /// The name of the layer in the file.
  std::string layer_name() const;
  bool is_geopackage() const;
};

/// FILE or FILE:LAYER. Throws IoError for a layer in a format that has one layer only.
OutputTarget output_target(const std::string& path);

/// The tables of the GeoPackage that the target would replace or add to, except the target's own layer: layers, tables
/// of attributes and rasters. Empty if there is no such file, or if it is no GeoPackage. Throws IoError if another
/// program has changes of it in a journal.
struct ExistingGeopackage {
  bool readable = false;
  bool has_layer = false;  ///< the target's own
  std::vector<std::string> others;
};
ExistingGeopackage existing_geopackage(const OutputTarget& target);

/// Copies the GeoPackage of the target to `stage`. Throws IoError.
void copy_geopackage(const OutputTarget& target, const std::string& stage);

}  // namespace oblast::io
