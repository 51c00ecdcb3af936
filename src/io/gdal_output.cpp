// Polygons of GDAL; see gdal_output.h.
#include "io/gdal_output.h"

#include <algorithm>

namespace oblast::io {

namespace {

double twice_signed_area(std::span<const Point> contour) {
  double sum = 0;
  Point previous = contour.back();
  for (const Point& p : contour) {
    sum += (previous.x - contour[0].x) * (p.y - contour[0].y) - (p.x - contour[0].x) * (previous.y - contour[0].y);
    previous = p;
  }
  return sum;
}

// The contour as a closed ring. If it is reversed, its first vertex stays the first.
void add_ring(OGRPolygon& polygon, std::span<const Point> contour, bool reverse, std::vector<Point>& scratch) {
  scratch.assign(contour.begin(), contour.end());
  if (reverse) std::reverse(scratch.begin() + 1, scratch.end());
  scratch.push_back(contour.front());
  auto ring = std::make_unique<OGRLinearRing>();
  const auto count = static_cast<int>(scratch.size());
  ring->setNumPoints(count, FALSE);
  for (int i = 0; i < count; ++i) ring->setPoint(i, scratch[i].x, scratch[i].y);
  polygon.addRingDirectly(ring.release());
}

}  // namespace

std::unique_ptr<OGRPolygon> make_polygon(const RegionView& regions, std::size_t p, Direction direction,
                                         std::vector<Point>& scratch) {
  auto polygon = std::make_unique<OGRPolygon>();
  bool outer = true;
  for (std::size_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c) {
    const auto contour = regions.contour(c);
    if (contour.empty()) continue;
    const double area = direction == Direction::esri ? twice_signed_area(contour) : 0;
    add_ring(*polygon, contour, outer ? area > 0 : area < 0, scratch);
    outer = false;
  }
  return polygon;
}

std::uint64_t vertex_count(const OGRPolygon& polygon) {
  std::uint64_t count = 0;
  for (const OGRLinearRing* ring : polygon) count += ring->getNumPoints() - 1;
  return count;
}

std::uint64_t vertex_count(const OGRGeometry* geometry) {
  if (!geometry) return 0;
  if (wkbFlatten(geometry->getGeometryType()) == wkbPolygon) return vertex_count(*geometry->toPolygon());
  std::uint64_t count = 0;
  for (const OGRGeometry* part : *geometry->toGeometryCollection()) count += vertex_count(*part->toPolygon());
  return count;
}

}  // namespace oblast::io
