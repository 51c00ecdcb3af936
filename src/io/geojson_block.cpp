// From JSON to polygons and values; see geojson_block.h.
#include "io/geojson_block.h"

#include <ogr_core.h>
#include <ogr_p.h>
#include <simdjson.h>

#include <deque>
#include <limits>

namespace oblast::io {

namespace {

namespace dom = simdjson::dom;

struct NotUnderstood {};  // by this reader: GDAL reads the file

template <class Result>
auto need(Result&& result) {
  if (result.error() != simdjson::SUCCESS) throw NotUnderstood();
  return std::forward<Result>(result).value_unsafe();
}

// Text that GDAL takes for a date or a time has a digit and a separator. Others need not be parsed.
PropertyKind kind_of_text(std::string_view text, const char* terminated) {
  if (text.find_first_of("-/:") == std::string_view::npos || text.find_first_of("0123456789") == std::string_view::npos)
    return PropertyKind::text;
  OGRField field;
  if (!OGRParseDate(terminated, &field, 0)) return PropertyKind::text;
  const bool date = text.find_first_of("-/") != std::string_view::npos;
  const bool time = text.find(':') != std::string_view::npos;
  return date && time ? PropertyKind::date_time : date ? PropertyKind::date : PropertyKind::time;
}

class BlockReader {
 public:
  BlockReader(BlockOptions options, LayerBuilder& builder, GeojsonBlock& block)
      : options_(options), builder_(builder), block_(block) {}

  void feature(dom::element element, std::int64_t number) {
    std::optional<dom::element> type, properties, geometry, id;
    for (const auto [key, value] : need(element.get_object())) {
      std::optional<dom::element>* member = key == "type"         ? &type
                                            : key == "properties" ? &properties
                                            : key == "geometry"   ? &geometry
                                            : key == "id"         ? &id
                                                                  : nullptr;
      if (!member || *member) throw NotUnderstood();
      *member = value;
    }
    if (!type || !properties || !geometry || need(type->get_string()) != "Feature") throw NotUnderstood();
    builder_.begin_feature(number);
    z_now_ = false;
    if (geometry->is_null()) {
      builder_.null_geometry();
    } else {
      read_geometry(need(geometry->get_object()));
    }
    builder_.end_feature();
    const bool is_new = read_properties(need(properties->get_object()), number == 0);
    read_id(id, number == 0);
    if (is_new || (z_now_ && !z_seen_)) add_sample(id, *properties);
    z_seen_ = z_seen_ || z_now_;
  }

 private:
  void read_geometry(dom::object object) {
    std::optional<dom::element> type, coordinates;
    for (const auto [key, value] : object) {
      std::optional<dom::element>* member = key == "type" ? &type : key == "coordinates" ? &coordinates : nullptr;
      if (!member || *member) throw NotUnderstood();
      *member = value;
    }
    if (!type || !coordinates) throw NotUnderstood();
    const std::string_view name = need(type->get_string());
    const dom::array parts = need(coordinates->get_array());
    if (name == "Polygon") {
      polygon(parts);
    } else if (name == "MultiPolygon") {
      for (const dom::element part : parts) polygon(need(part.get_array()));
    } else {
      throw NotUnderstood();
    }
  }

  // Rings without points are rare, and GDAL has its own rules for them.
  void polygon(dom::array rings) {
    builder_.begin_polygon();
    bool any = false;
    for (const dom::element ring : rings) {
      ring_.clear();
      for (const dom::element point : need(ring.get_array())) add_point(need(point.get_array()));
      if (ring_.empty()) throw NotUnderstood();
      builder_.add_ring(ring_);
      any = true;
    }
    if (!any) throw NotUnderstood();
    builder_.end_polygon();
  }

  void add_point(dom::array numbers) {
    double coordinates[3] = {};
    int count = 0;
    for (const dom::element number : numbers) {
      if (count == 3) throw NotUnderstood();
      coordinates[count++] = need(number.get_double());
    }
    if (count < 2) throw NotUnderstood();
    if (count == 3) {
      builder_.with_z();
      z_now_ = true;
    }
    ring_.push_back({coordinates[0], coordinates[1]});
  }

  // True if a column has a kind of value that it did not have before.
  bool read_properties(dom::object properties, bool first) {
    std::size_t column = 0;
    bool is_new = first;
    for (const auto [key, element] : properties) {
      if (first) add_key(key);
      if (column == block_.keys.size() || key != block_.keys[column]) throw NotUnderstood();
      const PropertyValue value = value_of(element);
      if (is_id_[column] && is_number_of_feature(value)) block_.ids.push_back(value.integer);
      if (options_.keep_values) block_.values.push_back(value);
      bool& seen = seen_[column * property_kinds + static_cast<std::size_t>(value.kind)];
      is_new = is_new || !seen;
      seen = true;
      ++column;
    }
    if (column != block_.keys.size()) throw NotUnderstood();
    return is_new;
  }

  static bool is_number_of_feature(const PropertyValue& value) {
    return (value.kind == PropertyKind::integer || value.kind == PropertyKind::integer64) && value.integer >= 0;
  }

  // GDAL takes "_id" for a sign of another format.
  void add_key(std::string_view key) {
    for (const std::string& other : block_.keys)
      if (other == key) throw NotUnderstood();
    if (key == "_id" || key.find('\0') != std::string_view::npos) throw NotUnderstood();
    is_id_.push_back(key == "id");
    if (key == "id") block_.id_place = IdPlace::property;
    block_.keys.emplace_back(key);
    seen_.resize(block_.keys.size() * property_kinds);
  }

  PropertyValue value_of(dom::element element) {
    PropertyValue value;
    switch (element.type()) {
      case dom::element_type::NULL_VALUE:
        return value;
      case dom::element_type::BOOL:
        value.kind = PropertyKind::boolean;
        value.integer = bool(element);
        return value;
      case dom::element_type::INT64: {
        using Limits = std::numeric_limits<std::int32_t>;
        value.integer = std::int64_t(element);
        const bool is_short = value.integer >= Limits::min() && value.integer <= Limits::max();
        value.kind = is_short ? PropertyKind::integer : PropertyKind::integer64;
        return value;
      }
      case dom::element_type::DOUBLE:
        value.kind = PropertyKind::real;
        value.real = double(element);
        return value;
      case dom::element_type::STRING:
        return text_value(std::string_view(element));
      default:  // lists, objects, integers beyond 64 bits
        throw NotUnderstood();
    }
  }

  PropertyValue text_value(std::string_view text) {
    if (text.find('\0') != std::string_view::npos) throw NotUnderstood();
    PropertyValue value;
    value.text = block_.texts.size();
    value.length = static_cast<std::uint32_t>(text.size());
    block_.texts.append(text) += '\0';
    value.kind = kind_of_text(text, block_.texts.data() + value.text);
    if (!options_.keep_values) block_.texts.clear();
    return value;
  }

  void read_id(const std::optional<dom::element>& id, bool first) {
    if (first && id) {
      if (block_.id_place == IdPlace::property) throw NotUnderstood();
      block_.id_place = IdPlace::feature;
    }
    if (id.has_value() != (block_.id_place == IdPlace::feature)) throw NotUnderstood();
    if (!id) return;
    const std::int64_t number = need(id->get_int64());
    if (number < 0) throw NotUnderstood();
    block_.ids.push_back(number);
  }

  void add_sample(const std::optional<dom::element>& id, dom::element properties) {
    std::string text = "{\"type\":\"Feature\",";
    if (id) text += "\"id\":" + simdjson::minify(*id) + ",";
    text += "\"properties\":" + simdjson::minify(properties);
    // With heights GDAL chooses another coordinate system, if the file names none.
    const char* const ring = z_now_ ? "[0,0,0],[1,0,0],[1,1,0],[0,0,0]" : "[0,0],[1,0],[1,1],[0,0]";
    text += std::string(",\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[[") + ring + "]]}}";
    block_.samples.push_back(std::move(text));
  }

  BlockOptions options_;
  LayerBuilder& builder_;
  GeojsonBlock& block_;
  std::vector<Point> ring_;
  bool z_now_ = false, z_seen_ = false;  // heights in this feature, in any
  std::vector<char> is_id_;              // by column
  std::deque<bool> seen_;                // by column and kind
};

}  // namespace

bool read_geojson_block(std::string& array, BlockOptions options, LayerBuilder& builder, GeojsonBlock& block) {
  array.reserve(array.size() + simdjson::SIMDJSON_PADDING);  // simdjson looks beyond the end
  simdjson::dom::parser parser;
  BlockReader reader(options, builder, block);
  try {
    std::int64_t number = 0;
    const dom::element features = need(parser.parse(array.data(), array.size(), false));
    for (const dom::element feature : need(features.get_array())) reader.feature(feature, number++);
    return number > 0;
  } catch (const NotUnderstood&) {
    return false;
  }
}

}  // namespace oblast::io
