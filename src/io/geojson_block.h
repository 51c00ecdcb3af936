// The features of a block of GeoJSON text, parsed by simdjson.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/layer_builder.h"

namespace oblast::io {

/// What GDAL distinguishes among the values of a property when it chooses the type of a column.
enum class PropertyKind : std::uint8_t { null, boolean, integer, integer64, real, text, date, time, date_time };
constexpr int property_kinds = 9;

struct PropertyValue {
  PropertyKind kind = PropertyKind::null;
  std::uint32_t length = 0;  ///< of text, in bytes
  union {
    std::int64_t integer = 0;  ///< also of a boolean
    double real;
    std::size_t text;  ///< where it begins in GeojsonBlock::texts; a zero byte follows it
  };
};

/// Where features have the numbers by which GDAL calls them.
enum class IdPlace : std::uint8_t { none, feature, property };

struct GeojsonBlock {
  Layer layer;                        ///< features are counted from 0
  std::vector<std::string> keys;      ///< of the properties of each feature, in this order
  std::vector<PropertyValue> values;  ///< by feature and key; empty if attributes are passed over
  std::string texts;
  IdPlace id_place = IdPlace::none;
  std::vector<std::int64_t> ids;  ///< by feature, if id_place is `feature`; else the whole numbers of the property
  /// The first feature that has a kind of value in a column, for each kind and column, and the first one with heights,
  /// as JSON in the order of the block. All others tell nothing new about the layer. Their polygons are not their own.
  std::vector<std::string> samples;
};

/// How a block is to be read.
struct BlockOptions {
  bool keep_values = false;
};

/// Reads a block, which stands in brackets, into `block`; its polygons go into block.layer
/// through `builder`. False if the block is not JSON, or
/// has something else than features with polygons whose properties are all the same keys in the same order, and none of
/// them a list or an object: then GDAL must read the file. Throws IoError, as LayerBuilder does.
bool read_geojson_block(std::string& array, BlockOptions options, LayerBuilder& builder, GeojsonBlock& block);

}  // namespace oblast::io
