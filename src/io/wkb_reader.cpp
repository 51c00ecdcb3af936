// With GDAL, geometry by geometry; see wkb_reader.h.
#include "io/wkb_reader.h"

#include <fmt/format.h>
#include <ogr_geometry.h>

#include <cctype>
#include <cstring>
#include <memory>

#include "io/gdal_geometry.h"
#include "io/gdal_session.h"
#include "io/layer_builder.h"
#include "io/srid.h"

namespace oblast::io {

namespace {

int digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const int letter = std::toupper(static_cast<unsigned char>(c));
  return letter >= 'A' && letter <= 'F' ? letter - 'A' + 10 : -1;
}

std::string from_hexadecimal(const std::string& text, const std::string& name) {
  std::string bytes;
  bytes.reserve(text.size() / 2);
  int high = -1;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (std::isspace(static_cast<unsigned char>(text[i])) && high < 0) continue;
    const int value = digit(text[i]);
    if (value < 0) throw IoError(fmt::format("{}, character {}: not a hexadecimal digit of WKB", name, i + 1));
    if (high >= 0) bytes += static_cast<char>(high * 16 + value);
    high = high < 0 ? value : -1;
  }
  if (high >= 0) throw IoError(name + ": WKB with half a byte at the end");
  return bytes;
}

// Takes the SRID out of the head of an EWKB geometry, which GDAL does not read: the rest of the head moves by its size,
// and `at` with it. Returns 0 if there is none.
unsigned take_srid(std::string& bytes, std::size_t& at) {
  constexpr std::size_t size = 4, head = 1 + 2 * size;
  constexpr std::uint32_t has_srid = 0x20000000;
  if (bytes.size() - at < head) return 0;
  const bool little = bytes[at] == '\1';
  const auto number = [&](std::size_t from) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + from, size);
    return little ? value : __builtin_bswap32(value);
  };
  const std::uint32_t type = number(at + 1), srid = number(at + 1 + size);
  if (!(type & has_srid)) return 0;
  const std::uint32_t plain = little ? type & ~has_srid : __builtin_bswap32(type & ~has_srid);
  at += size;
  bytes[at] = little ? '\1' : '\0';
  std::memcpy(bytes.data() + at + 1, &plain, size);
  return srid;
}

}  // namespace

Layer read_wkb(const std::string& data, const std::string& name, const ReadOptions& options) {
  const bool hexadecimal = !data.empty() && static_cast<unsigned char>(data.front()) > 1;
  std::string bytes = hexadecimal ? from_hexadecimal(data, name) : data;
  Layer layer;
  layer.files.push_back(name);
  LayerBuilder builder(layer, 0, options);
  CommonSrid srid(name);
  std::vector<Point> scratch;
  std::int64_t feature = 0;
  GdalMessages messages;
  for (std::size_t at = 0; at < bytes.size(); ++feature) {
    const std::string place = fmt::format("geometry {}, byte {}", feature + 1, at);
    if (srid.add(take_srid(bytes, at), place)) builder.set_crs(srid.wkt());
    builder.begin_feature(feature, fmt::format("byte {}", at));
    OGRGeometry* made = nullptr;
    std::size_t consumed = 0;
    const OGRErr error = OGRGeometryFactory::createFromWkb(bytes.data() + at, nullptr, &made, bytes.size() - at,
                                                           wkbVariantOldOgc, consumed);
    const std::unique_ptr<OGRGeometry> geometry(made);
    if (error != OGRERR_NONE || !geometry || consumed == 0 || consumed > bytes.size() - at)
      throw IoError(fmt::format("{}, {}: not Well-Known Binary, or cut off", name, place));
    if (geometry->Is3D()) builder.with_z();
    if (geometry->IsMeasured()) builder.with_m();
    add_geometry(*geometry, builder, scratch);
    builder.end_feature();
    at += consumed;
  }
  if (feature == 0) builder.set_crs({});
  builder.finish();
  return layer;
}

}  // namespace oblast::io
