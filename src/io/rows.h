// A layer with its rows and their attributes, read from files.
#pragma once

#include <oblast/features.h>

#include <string>
#include <vector>

#include "io/attribute_table.h"
#include "io/layer.h"
#include "io/read.h"

namespace oblast::io {

struct Rows {
  Layer layer;                      ///< has every feature; row f is layer.features[f]
  std::vector<std::uint32_t> ends;  ///< feature_ends of the rows
  AttributeTable table;

  FeatureView view() const { return {layer.regions, ends}; }
};

/// The feature_ends of layer.features, for a layer that was read with FeatureEntries::all.
std::vector<std::uint32_t> feature_ends(const Layer& layer);

/// Reads every feature of every path as a row, in the order of the files; also those without polygons. `notes` gets a
/// line for each column whose type differs between files. Throws IoError.
Rows read_rows(std::span<const std::string> paths, ReadOptions options, std::vector<std::string>& notes);

}  // namespace oblast::io
