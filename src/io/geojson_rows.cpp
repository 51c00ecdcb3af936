// Fields are set as GDAL's reader of GeoJSON sets them; see geojson_rows.h.
#include "io/geojson_rows.h"

#include <cpl_error.h>

#include <string_view>

namespace oblast::io {

namespace {

bool is_text(PropertyKind kind) { return kind >= PropertyKind::text; }
bool is_whole(PropertyKind kind) { return kind >= PropertyKind::boolean && kind <= PropertyKind::integer64; }

bool set_field(OGRFeature& feature, int field, const PropertyValue& value, const std::string& texts) {
  if (value.kind == PropertyKind::null) {
    feature.SetFieldNull(field);
    return true;
  }
  switch (feature.GetFieldDefnRef(field)->GetType()) {
    case OFTInteger:
      if (!is_whole(value.kind) || value.kind == PropertyKind::integer64) return false;
      feature.SetField(field, static_cast<int>(value.integer));
      return true;
    case OFTInteger64:
      if (!is_whole(value.kind)) return false;
      feature.SetField(field, static_cast<GIntBig>(value.integer));
      return true;
    case OFTReal:
      if (value.kind != PropertyKind::real && !is_whole(value.kind)) return false;
      feature.SetField(field, value.kind == PropertyKind::real ? value.real : static_cast<double>(value.integer));
      return true;
    case OFTString:
    case OFTDate:
    case OFTTime:
    case OFTDateTime:
      if (!is_text(value.kind)) return false;
      feature.SetField(field, texts.c_str() + value.text);
      return true;
    default:
      return false;
  }
}

}  // namespace

bool make_rows(const GeojsonBlock& block, OGRFeatureDefn& definition, std::span<const std::int64_t> ids,
               std::span<std::unique_ptr<OGRFeature>> rows) {
  const std::size_t columns = block.keys.size();
  std::vector<int> fields;
  for (const std::string& key : block.keys) fields.push_back(definition.GetFieldIndexCaseSensitive(key.c_str()));
  for (const int field : fields)
    if (field < 0) return false;
  CPLErrorHandlerPusher quiet(CPLQuietErrorHandler);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    rows[row] = std::make_unique<OGRFeature>(&definition);
    rows[row]->SetFID(ids[row]);
    for (std::size_t c = 0; c < columns; ++c)
      if (!set_field(*rows[row], fields[c], block.values[row * columns + c], block.texts)) return false;
  }
  return true;
}

}  // namespace oblast::io
