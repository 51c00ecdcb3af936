// A small file in memory stands for the large one; see geojson_schema.h.
#include "io/geojson_schema.h"

#include <fmt/format.h>

#include <atomic>
#include <filesystem>

#include "io/attribute_data.h"
#include "io/crs_reader.h"
#include "io/gdal_source.h"
#include "io/standard_input.h"

namespace oblast::io {

std::optional<GeojsonSchema> geojson_schema(const std::string& head, std::span<const std::string> samples,
                                            const NamedSource& named) {
  static std::atomic<std::uint64_t> files = 0;
  std::string text = head;
  for (const std::string& sample : samples) text += (&sample == samples.data() ? "" : ",") + sample;
  text += "]}";
  // GDAL calls the layer as the file is called.
  const std::string name = std::filesystem::path(named.source.path).filename().string();
  const MemoryFile file(std::move(text), fmt::format("schema-{}/{}", files++, name));
  try {
    GdalSource source({file.path(), named.source.layer}, named.name);
    OGRLayer& layer = source.layer();
    if (!source.is_driver("GeoJSON") || source.messages().failed()) return std::nullopt;
    GeojsonSchema schema;
    schema.crs_wkt = read_crs(layer, file.path());
    schema.notes = source.notes();
    schema.id_column = layer.GetFIDColumn();
    schema.definition.reset(layer.GetLayerDefn());
    schema.definition->Reference();
    for (int f = 0; f < schema.definition->GetFieldCount(); ++f)
      schema.columns.push_back(column_of(*schema.definition->GetFieldDefn(f)));
    return schema;
  } catch (const IoError&) {  // GDAL will say it of the whole file
    return std::nullopt;
  }
}

}  // namespace oblast::io
