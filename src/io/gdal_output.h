// What the writers of GDAL's formats share. Only for use inside src/io, because it has GDAL types.
#pragma once

#include <gdal_priv.h>
#include <oblast/region_set.h>
#include <ogrsf_frmts.h>

#include <memory>
#include <string>
#include <vector>

#include "io/gdal_session.h"
#include "io/layer.h"

namespace oblast::io {

struct DatasetCloser {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, DatasetCloser>;

/// GDAL reports errors by return value, by message, or by both. Either is an error here.
class Check {
 public:
  Check(const GdalMessages& messages, const std::string& name) : messages_(messages), name_(name) {}
  void operator()(bool good) const {
    if (good && !messages_.failed()) return;
    throw IoError("cannot write " + name_ + ": " + messages_.text("GDAL failed and gave no reason"));
  }

 private:
  const GdalMessages& messages_;
  const std::string& name_;
};

/// The directions of contours in a file.
enum class Direction {
  as_given,  ///< a result's: outer anticlockwise, holes clockwise
  esri,      ///< Shapefile demands the outer contour clockwise and holes anticlockwise
};

/// Polygon p of the regions, with closed rings.
std::unique_ptr<OGRPolygon> make_polygon(const RegionView& regions, std::size_t p, Direction direction,
                                         std::vector<Point>& scratch);

/// The vertices of a polygon, without the closing points.
std::uint64_t vertex_count(const OGRPolygon& polygon);
/// Of a polygon, or of a collection of them; 0 for nullptr.
std::uint64_t vertex_count(const OGRGeometry* geometry);

}  // namespace oblast::io
