// The inputs of a call, as a list of files and layers.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace oblast::io {

/// A file, or one of its layers.
struct Source {
  std::string path;   ///< `-` is standard input; GDAL's virtual paths (/vsizip/...) are allowed
  std::string layer;  ///< empty: the only one

  /// For messages: "fires.gpkg", "fires.gpkg:june", "standard input".
  std::string name() const;
};

struct SourceList {
  std::vector<Source> sources;
  std::vector<std::string> notes;  ///< what was passed over in folders: one line each
};

/// Which files are meant.
struct SourceOptions {
  std::string layer;   ///< the layer of each file for which none is named
  std::string output;  ///< the file that the call writes: it is passed over in folders; empty: none
};

/// A path is FILE, FILE:LAYER, a folder (all vector files in it, sorted by the bytes of their names), a `.zip` file
/// with one vector file in it, or ARCHIVE.zip:FILE. `-` stays. Throws IoError for a name that does not exist, for a
/// folder without vector files, and for a .zip file with several of them.
SourceList list_sources(std::span<const std::string> paths, const SourceOptions& options);

}  // namespace oblast::io
