// Bytes in the order of the standard (OGC 12-128r18, clause 2.1.3); see geopackage_geometry.h.
#include "io/geopackage_geometry.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

namespace oblast::io {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are in memory");

constexpr std::uint32_t wkb_polygon_type = 3, wkb_multipolygon_type = 6;

class Bytes {
 public:
  explicit Bytes(std::vector<unsigned char>& bytes) : bytes_(bytes) { bytes_.clear(); }
  void add(std::span<const Point> points) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + points.size_bytes());
    std::memcpy(bytes_.data() + at, points.data(), points.size_bytes());
  }
  template <class Number>
  void add(Number number) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + sizeof number);
    std::memcpy(bytes_.data() + at, &number, sizeof number);
  }
  void add_type(std::uint32_t type) {
    add(std::uint8_t{1});  // little-endian
    add(type);
  }

 private:
  std::vector<unsigned char>& bytes_;
};

Box box_of(const FeatureView& rows, std::size_t row) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box{infinity, infinity, -infinity, -infinity};
  const RegionView& regions = rows.regions;
  for (std::size_t p = rows.feature_begin(row); p < rows.feature_end(row); ++p) {
    for (std::size_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c) {
      for (const Point& point : regions.contour(c)) {
        box.x0 = std::min(box.x0, point.x);
        box.y0 = std::min(box.y0, point.y);
        box.x1 = std::max(box.x1, point.x);
        box.y1 = std::max(box.y1, point.y);
      }
    }
  }
  return box;
}

void add_polygon(const RegionView& regions, std::size_t p, Bytes& bytes) {
  bytes.add_type(wkb_polygon_type);
  std::uint32_t rings = 0;
  for (std::size_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c) rings += !regions.contour(c).empty();
  bytes.add(rings);
  for (std::size_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c) {
    const std::span<const Point> contour = regions.contour(c);
    if (contour.empty()) continue;
    bytes.add(static_cast<std::uint32_t>(contour.size() + 1));
    bytes.add(contour);
    bytes.add(contour.first(1));
  }
}

}  // namespace

void geopackage_blob(const FeatureView& rows, std::size_t row, GeopackageShape shape, std::int32_t srs_id,
                     std::vector<unsigned char>& blob, Box& box) {
  box = box_of(rows, row);
  Bytes bytes(blob);
  bytes.add(std::uint8_t{'G'});
  bytes.add(std::uint8_t{'P'});
  bytes.add(std::uint8_t{0});  // version 1
  bytes.add(std::uint8_t{3});  // little-endian, with the box of x and y
  bytes.add(srs_id);
  for (const double bound : {box.x0, box.x1, box.y0, box.y1}) bytes.add(bound);
  const std::size_t begin = rows.feature_begin(row), end = rows.feature_end(row);
  if (shape == GeopackageShape::multipolygon) {
    bytes.add_type(wkb_multipolygon_type);
    bytes.add(static_cast<std::uint32_t>(end - begin));
  }
  for (std::size_t p = begin; p < end; ++p) add_polygon(rows.regions, p, bytes);
}

}  // namespace oblast::io
