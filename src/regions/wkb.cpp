// Well-Known Binary (ISO 13249-3, section 5.1.47; EWKB as PostGIS writes it), by one pass over the bytes.
//
// Nothing is read or allocated before it is known that the bytes for it exist. Before a count is used, it is compared
// with the number of remaining bytes, divided by the smallest size of an element. So a loop over it is no longer than
// the input.
#include <oblast/wkb.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>

#include "base/public_call.h"
#include "regions/read_polygons.h"
#include "regions/validate.h"

namespace oblast {
using namespace internal;
namespace {

constexpr std::uint32_t polygon_type = 3, multipolygon_type = 6, collection_type = 7;
constexpr std::uint32_t z_bit = 0x80000000, m_bit = 0x40000000, srid_bit = 0x20000000;
constexpr std::size_t header_bytes = 1 + 4 + 4;  // of a geometry: byte order, type, count

template <class T>
T swapped(T value) {
  auto bytes = std::bit_cast<std::array<std::byte, sizeof(T)>>(value);
  std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<T>(bytes);
}

class WkbReader {
 public:
  explicit WkbReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  RegionSet read() {
    geometry(0, 0);
    if (at_ != bytes_.size())
      fail(std::to_string(bytes_.size() - at_) + " bytes follow the geometry; nothing may follow it", at_);
    return collector_.take();
  }

 private:
  [[noreturn]] static void fail(const std::string& what, std::size_t byte) {
    throw_at_byte(ErrorCode::bad_wkb, "not WKB of polygons: " + what, byte);
  }

  std::size_t left() const { return bytes_.size() - at_; }

  template <class T>
  T number() {
    if (left() < sizeof(T)) fail("the bytes end inside a number", at_);
    T value;
    std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return swap_ ? swapped(value) : value;
  }

  double coordinate() {
    const std::size_t place = at_;
    return checked_coordinate(number<double>(), place);
  }

  /// Reads a count of elements that have at least `bytes_each` bytes each.
  std::uint32_t count(std::size_t bytes_each, const char* what) {
    const std::size_t place = at_;
    const auto counted = number<std::uint32_t>();
    if (counted > left() / bytes_each)
      fail("the count is " + std::to_string(counted) + ' ' + what + ", but the remaining " + std::to_string(left()) +
               " bytes are too few for them",
           place);
    return counted;
  }

  /// Reads a header. Returns the type without its dimensions, and stores the number of doubles per point.
  std::uint32_t header() {
    if (left() == 0) fail("the bytes end where a geometry must begin", at_);
    const auto order = std::to_integer<unsigned>(bytes_[at_]);
    if (order > 1) fail("the byte order is " + std::to_string(order) + "; it must be 0 or 1", at_);
    ++at_;
    swap_ = (order == 1) != (std::endian::native == std::endian::little);
    const auto code = number<std::uint32_t>();
    if (code & srid_bit) (void)number<std::uint32_t>();
    const std::uint32_t iso = code & ~(z_bit | m_bit | srid_bit), dimensions = iso / 1000;
    const bool z = (code & z_bit) != 0 || dimensions == 1 || dimensions == 3;
    const bool m = (code & m_bit) != 0 || dimensions == 2 || dimensions == 3;
    doubles_a_point_ = 2u + static_cast<unsigned>(z) + static_cast<unsigned>(m);
    return dimensions > 3 ? iso : iso % 1000;
  }

  /// `expected`: the type that it must have, 0 for any of the three.
  void geometry(std::uint32_t expected, int depth) {
    const std::size_t place = at_;
    const std::uint32_t type = header();
    if (expected != 0 && type != expected)
      fail("a multipolygon has a geometry of type " + std::to_string(type) + "; it may have only polygons (3)",
           place + 1);
    if (type == polygon_type) return polygon();
    if (type != multipolygon_type && type != collection_type)
      fail("the type is " + std::to_string(type) + "; it must be polygon (3), multipolygon (6) or collection (7)",
           place + 1);
    if (depth == deepest_collection)
      fail("collections are nested more than " + std::to_string(deepest_collection) + " levels deep", place);
    const std::uint32_t parts = count(header_bytes, "geometries");
    for (std::uint32_t i = 0; i < parts; ++i) geometry(type == multipolygon_type ? polygon_type : 0, depth + 1);
  }

  void polygon() {
    const std::uint32_t rings = count(sizeof(std::uint32_t), "rings");
    collector_.begin_polygon();
    for (std::uint32_t i = 0; i < rings; ++i) ring();
    collector_.end_polygon();
  }

  void ring() {
    steps_();
    const std::uint32_t points = count(doubles_a_point_ * sizeof(double), "points");
    const std::size_t others = (doubles_a_point_ - 2) * sizeof(double);
    for (std::uint32_t i = 0; i < points; ++i) {
      steps_();
      const double x = coordinate(), y = coordinate();
      collector_.add({x, y});
      at_ += others;
    }
    collector_.end_ring();
  }

  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  bool swap_ = false;                ///< for the current geometry: bytes must be swapped
  std::size_t doubles_a_point_ = 2;  ///< for the current geometry
  PolygonCollector collector_;
  Steps steps_;
};

/// Writes little-endian numbers, one after another, into an array of the right size.
class WkbWriter {
 public:
  explicit WkbWriter(std::size_t bytes) : bytes_(bytes) {}

  template <class T>
  void add(T value) {
    if constexpr (std::endian::native == std::endian::big) value = swapped(value);
    std::memcpy(bytes_.data() + at_, &value, sizeof(T));
    at_ += sizeof(T);
  }
  void add_header(std::uint32_t type, std::size_t count) {
    add(std::byte{1});
    add(type);
    add(static_cast<std::uint32_t>(count));
  }
  void add_polygon(const PolygonView& polygon, std::size_t rings) {
    add_header(polygon_type, rings);
    for (const std::span<const Point> contour : polygon.contours()) {
      if (contour.empty()) continue;
      add(static_cast<std::uint32_t>(contour.size() + 1));
      const auto add_point = [&](const Point& p) { add(p.x), add(p.y); };
      for (const Point& p : contour) steps_(), add_point(p);
      add_point(contour.front());
    }
  }

  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
  std::size_t at_ = 0;
  Steps steps_;
};

std::size_t filled_rings(const PolygonView& polygon) {
  std::size_t rings = 0;
  for (const std::span<const Point> contour : polygon.contours()) rings += contour.empty() ? 0 : 1;
  return rings;
}

std::vector<std::byte> written(const RegionView& regions) {
  std::size_t polygons = 0, rings = 0;
  for (const PolygonView polygon : regions.polygons()) {
    const std::size_t filled = filled_rings(polygon);
    polygons += filled > 0 ? 1 : 0;
    rings += filled;
  }
  const std::size_t bytes = header_bytes * (polygons + (polygons == 1 ? 0 : 1)) + rings * sizeof(std::uint32_t) +
                            (regions.points.size() + rings) * sizeof(Point);
  const Charge charge(bytes);
  WkbWriter writer(bytes);
  if (polygons != 1) writer.add_header(multipolygon_type, polygons);
  for (const PolygonView polygon : regions.polygons())
    if (const std::size_t filled = filled_rings(polygon)) writer.add_polygon(polygon, filled);
  return writer.take();
}

}  // namespace

RegionSet read_wkb(std::span<const std::byte> bytes, const CallOptions& options) {
  // Counts as a call on no vertices, so it stays on this thread.
  return public_call(options, 0, [&](Control&) { return WkbReader(bytes).read(); });
}

std::vector<std::byte> to_wkb(const RegionView& regions, const CallOptions& options) {
  return public_call(options, regions.points.size(), [&](Control&) {
    validate(regions, 0);
    return written(regions);
  });
}

}  // namespace oblast
