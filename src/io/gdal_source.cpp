// Opening; see gdal_source.h.
#include "io/gdal_source.h"

#include <gdal_priv.h>

#include "io/formats.h"
#include "io/layer.h"

namespace oblast::io {

GdalSource::GdalSource(const std::string& path) {
  register_gdal_drivers();
  const Format* format = format_of(path);
  dataset_.reset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                                   format && format->drivers[0] ? format->drivers : nullptr));
  if (!dataset_)
    throw IoError(path +
                  " is not a vector file that can be read: " + messages_.text("no driver of GDAL recognises it"));
  for (OGRLayer* layer : dataset_->GetLayers()) {
    if (layer->GetGeomType() == wkbNone) continue;  // a table of attributes
    layers_.push_back({layer, dataset_->GetLayerCount() == 1 ? path : path + " (layer " + layer->GetName() + ")"});
  }
  if (layers_.empty()) throw IoError(path + " has no layer with geometry");
}

void set_condition(const GdalSource::Entry& entry, const std::string& where, GdalMessages& messages) {
  if (where.empty()) return;
  messages.clear();
  if (entry.layer->SetAttributeFilter(where.c_str()) != OGRERR_NONE || messages.failed())
    throw IoError(entry.name + ": the condition \"" + where +
                  "\" is not understood: " + messages.text("GDAL gave no reason"));
}

}  // namespace oblast::io
