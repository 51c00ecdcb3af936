// Polygons, lines and points out of geometries; see gdal_geometry.h.
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

void add_line(const OGRLineString& line, LayerBuilder& builder, std::vector<Point>& scratch) {
  if (!builder.keeps_others()) return builder.line(line.getGeometryName());
  scratch.resize(line.getNumPoints());
  if (!scratch.empty()) line.getPoints(&scratch[0].x, sizeof(Point), &scratch[0].y, sizeof(Point));
  builder.add_line(scratch);
}

void add_point(const OGRPoint& point, LayerBuilder& builder) {
  if (!builder.keeps_others()) return builder.point(point.getGeometryName());
  if (!point.IsEmpty()) builder.add_point({point.getX(), point.getY()});
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
      return add_line(*geometry.toLineString(), builder, scratch);
    case wkbMultiLineString:
      if (!builder.keeps_others()) return builder.line(geometry.getGeometryName());
      for (const OGRLineString* line : geometry.toMultiLineString()) add_line(*line, builder, scratch);
      return;
    case wkbPoint:
      return add_point(*geometry.toPoint(), builder);
    case wkbMultiPoint:
      if (!builder.keeps_others()) return builder.point(geometry.getGeometryName());
      for (const OGRPoint* point : geometry.toMultiPoint()) add_point(*point, builder);
      return;
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
