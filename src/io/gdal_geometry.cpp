// Polygons out of geometries; see gdal_geometry.h.
#include "io/gdal_geometry.h"

namespace oblast::io {

namespace {

void add_rings(const OGRPolygon& polygon, LayerBuilder& builder, std::vector<Point>& scratch) {
  for (const OGRLinearRing* ring : polygon) {
    scratch.resize(ring->getNumPoints());
    if (!scratch.empty()) ring->getPoints(&scratch[0].x, sizeof(Point), &scratch[0].y, sizeof(Point));
    builder.add_ring(scratch);
  }
}

void add_polygon(const OGRPolygon& polygon, LayerBuilder& builder, std::vector<Point>& scratch) {
  builder.begin_polygon();
  add_rings(polygon, builder, scratch);
  builder.end_polygon();
}

[[noreturn]] void refuse_type(const OGRGeometry& geometry, const LayerBuilder& builder) {
  const std::string type = geometry.getGeometryName();
  if (OGR_GT_IsNonLinear(geometry.getGeometryType())) {
    builder.refuse(type + " is a curve type: only straight edges are read; convert it to POLYGON first");
  }
  builder.refuse(type + " is not a polygon of the plane");
}

}  // namespace

void add_geometry(const OGRGeometry& geometry, LayerBuilder& builder, std::vector<Point>& scratch) {
  switch (wkbFlatten(geometry.getGeometryType())) {
    case wkbPolygon:
      return add_polygon(*geometry.toPolygon(), builder, scratch);
    case wkbMultiPolygon:
      for (const OGRPolygon* polygon : geometry.toMultiPolygon()) add_polygon(*polygon, builder, scratch);
      return;
    case wkbGeometryCollection:
      for (const OGRGeometry* member : geometry.toGeometryCollection()) add_geometry(*member, builder, scratch);
      return;
    case wkbLineString:
    case wkbMultiLineString:
      return builder.line(geometry.getGeometryName());
    case wkbPoint:
    case wkbMultiPoint:
      return builder.point(geometry.getGeometryName());
    default:
      refuse_type(geometry, builder);
  }
}

void add_record(const OGRGeometry& geometry, LayerBuilder& builder, std::vector<Point>& scratch) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (type != wkbMultiPolygon && type != wkbGeometryCollection) return add_geometry(geometry, builder, scratch);
  builder.begin_polygon();
  for (const OGRGeometry* member : *geometry.toGeometryCollection()) {
    if (wkbFlatten(member->getGeometryType()) != wkbPolygon) refuse_type(*member, builder);
    add_rings(*member->toPolygon(), builder, scratch);
  }
  builder.end_polygon();
}

}  // namespace oblast::io
