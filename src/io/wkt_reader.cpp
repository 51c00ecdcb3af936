// Well-Known Text as a layer: each geometry is a feature, with its line in messages.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "io/layer_builder.h"
#include "io/read.h"
#include "io/srid.h"
#include "text/wkt_scanner.h"

namespace oblast::io {

namespace {

class WktLayer {
 public:
  WktLayer(std::string_view text, const std::string& name, Layer& layer, const ReadOptions& options)
      : text_(text), name_(name), srid_(name), builder_(layer, 0, options) {}

  void read() {
    text::WktScanner<WktLayer> scanner(text_, *this);
    std::int64_t feature = 0;
    for (; scanner.find_next(); ++feature) {
      const std::size_t at = scanner.byte();
      line_ += static_cast<std::size_t>(std::count(text_.begin() + counted_, text_.begin() + at, '\n'));
      counted_ = at;
      const std::string place = fmt::format("line {}", line_);
      if (srid_.add(scanner.srid(), place)) builder_.set_crs(srid_.wkt());
      builder_.begin_feature(feature, place);
      scanner.geometry();
      builder_.end_feature();
    }
    if (feature == 0) builder_.set_crs({});
    builder_.finish();
  }

  // What the scanner calls.

  bool enter(const text::WktType& type, std::size_t, std::size_t byte) {
    static const std::set<std::string_view> lines{"LINESTRING", "MULTILINESTRING"}, points{"POINT", "MULTIPOINT"},
        areas{"POLYGON", "MULTIPOLYGON", "GEOMETRYCOLLECTION"}, surfaces{"TIN", "TRIANGLE", "POLYHEDRALSURFACE"},
        curves{"CIRCULARSTRING", "COMPOUNDCURVE", "CURVEPOLYGON", "MULTICURVE", "MULTISURFACE", "CURVE", "SURFACE"};
    if (type.z) builder_.with_z();
    if (type.m) builder_.with_m();
    measured_ = type.m;
    if (areas.contains(type.name)) return true;
    if (curves.contains(type.name))
      builder_.refuse(type.name + " is a curve type: only straight edges are read; convert it to POLYGON first");
    if (surfaces.contains(type.name)) builder_.refuse(type.name + " is not a polygon of the plane");
    const bool is_line = lines.contains(type.name);
    if (!is_line && !points.contains(type.name)) fail("unknown geometry type " + type.name, byte);
    if (builder_.keeps_others()) return true;
    is_line ? builder_.line(type.name) : builder_.point(type.name);
    return false;
  }

  void begin_polygon() { builder_.begin_polygon(); }
  void vertex(const text::WktVertex& vertex) {
    vertices_.push_back(vertex.at);
    if (vertex.further == 2 || (vertex.further == 1 && !measured_)) builder_.with_z();
    if (vertex.further == 2 || (vertex.further == 1 && measured_)) builder_.with_m();
  }
  void end_ring() {
    builder_.add_ring(vertices_);
    vertices_.clear();
  }
  void end_polygon() { builder_.end_polygon(); }
  void end_line() {
    builder_.add_line(vertices_);
    vertices_.clear();
  }
  void end_point() {
    builder_.add_point(vertices_.back());
    vertices_.clear();
  }
  void poll() {}

  [[noreturn]] void fail(const std::string& what, std::size_t byte) const {
    const std::string_view before = text_.substr(0, byte);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t start = before.rfind('\n') + 1;  // 0 if there is none
    throw IoError(fmt::format("{}, line {}, column {}: {}{}", name_, line, byte - start + 1, what,
                              byte == text_.size() ? ", found the end of the text" : ""));
  }
  [[noreturn]] void beyond_double(std::size_t byte) const { fail("the number is outside the range of a double", byte); }

 private:
  std::string_view text_;
  const std::string& name_;
  std::size_t line_ = 1;
  std::size_t counted_ = 0;  // bytes whose line ends are counted
  CommonSrid srid_;
  LayerBuilder builder_;
  std::vector<Point> vertices_;  // of the ring or line
  bool measured_ = false;        // a third number is M
};

}  // namespace

Layer read_wkt(const std::string& text, const std::string& name, const ReadOptions& options) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  std::string_view contents = text;
  if (contents.starts_with(byte_order_mark)) contents.remove_prefix(byte_order_mark.size());
  Layer layer;
  layer.files.push_back(name);
  WktLayer(contents, name, layer, options).read();
  return layer;
}

}  // namespace oblast::io
