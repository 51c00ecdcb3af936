// Well-Known Text of polygons. The grammar is in text/wkt_scanner.h.
#include <oblast/wkt.h>

#include <charconv>

#include "base/public_call.h"
#include "regions/read_polygons.h"
#include "regions/validate.h"
#include "text/wkt_scanner.h"

namespace oblast {
using namespace internal;
namespace {

/// The polygons of one geometry.
class WktPolygons {
 public:
  RegionSet read(std::string_view text) {
    text::WktScanner<WktPolygons> scanner(text, *this);
    (void)scanner.srid();
    scanner.geometry();
    (void)scanner.accepts(';');
    if (scanner.find_next()) fail("text follows the geometry; only one geometry is read", scanner.byte());
    return collector_.take();
  }

  // What the scanner calls.

  bool enter(const text::WktType& type, std::size_t depth, std::size_t byte) const {
    const bool is_collection = type.name == "GEOMETRYCOLLECTION";
    if (!is_collection && type.name != "POLYGON" && type.name != "MULTIPOLYGON")
      fail("expected POLYGON, MULTIPOLYGON or GEOMETRYCOLLECTION", byte);
    if (is_collection && depth == deepest_collection)
      fail("collections are nested more than " + std::to_string(deepest_collection) + " levels deep", byte);
    return true;
  }

  void begin_polygon() { collector_.begin_polygon(); }
  void vertex(const text::WktVertex& vertex) {
    const double x = checked_coordinate(vertex.at.x, vertex.x_byte);
    collector_.add({x, checked_coordinate(vertex.at.y, vertex.y_byte)});
  }
  void end_ring() { collector_.end_ring(); }
  void end_polygon() { collector_.end_polygon(); }
  void end_line() {}
  void end_point() {}
  void poll() { steps_(); }

  [[noreturn]] void fail(const std::string& what, std::size_t byte) const {
    throw_at_byte(ErrorCode::bad_wkt, "not WKT of polygons: " + what, byte);
  }
  [[noreturn]] void beyond_double(std::size_t byte) const {
    throw_at_byte(ErrorCode::out_of_domain, "the number is too large or too small for a double", byte);
  }

 private:
  PolygonCollector collector_;
  Steps steps_;
};

class WktWriter {
 public:
  std::string write(const RegionView& regions) {
    std::size_t polygons = 0;
    for (const PolygonView polygon : regions.polygons()) polygons += is_filled(polygon) ? 1 : 0;
    if (polygons == 0) return "MULTIPOLYGON EMPTY";
    text_ = polygons == 1 ? "POLYGON " : "MULTIPOLYGON (";
    const char* separator = "";
    for (const PolygonView polygon : regions.polygons()) {
      if (!is_filled(polygon)) continue;
      text_ += separator;
      separator = ", ";
      add(polygon);
    }
    if (polygons > 1) text_ += ')';
    return std::move(text_);
  }

 private:
  static bool is_filled(const PolygonView& polygon) { return !polygon.view().points.empty(); }

  void add(const PolygonView& polygon) {
    const char* separator = "(";
    for (const std::span<const Point> contour : polygon.contours()) {
      if (contour.empty()) continue;
      text_ += separator;
      separator = ", ";
      text_ += '(';
      for (const Point& p : contour) {
        steps_();
        add(p);
        text_ += ", ";
      }
      add(contour.front());
      text_ += ')';
    }
    text_ += ')';
  }

  void add(const Point& p) {
    char digits[64];  // the longest shortest form of a number has 24 characters
    const auto x = std::to_chars(digits, digits + sizeof digits / 2, p.x);
    *x.ptr = ' ';
    const auto y = std::to_chars(x.ptr + 1, digits + sizeof digits, p.y);
    make_room(static_cast<std::size_t>(y.ptr - digits) + 4);
    text_.append(digits, y.ptr);
  }

  void make_room(std::size_t bytes) {
    if (text_.size() + bytes <= text_.capacity()) return;
    const std::size_t room = 2 * (text_.size() + bytes);
    Charge charge(room);
    text_.reserve(room);
    charge_ = std::move(charge);
  }

  std::string text_;
  Charge charge_;
  Steps steps_;
};

}  // namespace

RegionSet read_wkt(std::string_view text, const CallOptions& options) {
  // Counts as a call on no vertices, so it stays on this thread.
  return public_call(options, 0, [&](Control&) { return WktPolygons().read(text); });
}

std::string to_wkt(const RegionView& regions, const CallOptions& options) {
  return public_call(options, regions.points.size(), [&](Control&) {
    validate(regions, 0);
    return WktWriter().write(regions);
  });
}

}  // namespace oblast
