// A GeoJSON text cut into blocks of features, which are read at the same time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/text_source.h"

namespace oblast::io {

/// A FeatureCollection in pieces. A cut may be wrong, because it is a guess: text in a string may look like the
/// beginning of a feature. But if each block is JSON once it stands in brackets, then all cuts are right: the first
/// block begins at a feature, and the end of a block that is complete is where the next feature begins.
struct GeojsonText {
  /// Features with commas between them: bytes [begin, end).
  struct Block {
    std::uint64_t begin = 0, end = 0;
  };
  std::string head;  ///< to the bracket that opens "features", with it
  std::vector<Block> blocks;
};

/// `block_size` is in bytes: blocks have at least as many, but the last. Nothing if the text is not a FeatureCollection
/// with one or more features whose last member is "features". Throws IoError.
std::optional<GeojsonText> cut_geojson(const TextSource& source, std::uint64_t block_size);

}  // namespace oblast::io
