// Opening; see gdal_source.h.
#include "io/gdal_source.h"

#include <fmt/format.h>
#include <gdal_priv.h>

#include "io/formats.h"
#include "io/layer.h"
#include "io/paths.h"

namespace oblast::io {

namespace {

std::string type_of(OGRLayer& layer) {
  const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
  if (type == wkbPoint || type == wkbMultiPoint) return "points";
  if (type == wkbLineString || type == wkbMultiLineString) return "lines";
  if (type == wkbPolygon || type == wkbMultiPolygon) return "polygons";
  return "any geometry";
}

std::string list_of(const std::vector<OGRLayer*>& layers) {
  std::vector<std::string> names;
  names.reserve(layers.size());
  for (OGRLayer* layer : layers) names.push_back(fmt::format("{} ({})", layer->GetName(), type_of(*layer)));
  return name_list(names);
}

// Columns of CSV are text unless a .csvt file gives their types: a guess would make 7 of 007.
const char* const csv_options[] = {"KEEP_GEOM_COLUMNS=NO", "EMPTY_STRING_AS_NULL=YES", nullptr};

}  // namespace

GdalSource::GdalSource(const Source& source, const std::string& name) : name_(name) {
  register_gdal_drivers();
  const std::string& path = source.path;
  const Format* format = format_of(path);
  if (format) require_driver(*format, path);
  const bool csv = format && format->extension == ".csv";
  dataset_.reset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                                   format && format->drivers[0] ? format->drivers : nullptr,
                                   csv ? csv_options : nullptr));
  if (!dataset_)
    throw IoError(name +
                  " is not a vector file that can be read: " + messages_.text("no driver of GDAL recognises it"));
  std::vector<OGRLayer*> layers;
  std::vector<std::string> tables;
  for (OGRLayer* layer : dataset_->GetLayers()) {
    if (layer->GetGeomType() == wkbNone) {
      tables.emplace_back(layer->GetName());
    } else {
      layers.push_back(layer);
    }
    if (!source.layer.empty() && source.layer == layer->GetName()) layer_ = layer;
  }
  if (layers.empty())
    throw IoError(name + " has no layer with geometry" + (csv ? "; a column with WKT must be called WKT" : ""));
  if (!source.layer.empty()) {
    if (!layer_) throw IoError(fmt::format("{} has no layer {}; it has {}", path, source.layer, list_of(layers)));
    if (layer_->GetGeomType() == wkbNone) throw IoError(name + " is a table without geometry");
    return;
  }
  if (layers.size() > 1)
    throw IoError(fmt::format("{} has {} layers: {}; name one, as in {}:{} or --layer {}", name, layers.size(),
                              list_of(layers), path, layers.front()->GetName(), layers.front()->GetName()));
  layer_ = layers.front();
  if (!tables.empty())
    notes_.push_back(fmt::format("{}: {} without geometry {} not read: {}", name,
                                 tables.size() == 1 ? "a table" : fmt::format("{} tables", tables.size()),
                                 tables.size() == 1 ? "was" : "were", name_list(tables)));
}

bool GdalSource::is_driver(const char* name) const { return EQUAL(dataset_->GetDriverName(), name); }

void GdalSource::set_condition(const std::string& where) {
  if (where.empty()) return;
  messages_.clear();
  if (layer_->SetAttributeFilter(where.c_str()) != OGRERR_NONE || messages_.failed())
    throw IoError(name_ + ": the condition \"" + where +
                  "\" is not understood: " + messages_.text("GDAL gave no reason"));
}

}  // namespace oblast::io
