// Well-Known Text (OGC 06-103r4, section 7; EWKT as PostGIS writes it), by one pass over the characters.
#include <oblast/wkt.h>

#include <charconv>

#include "base/public_call.h"
#include "regions/read_polygons.h"
#include "regions/validate.h"

namespace oblast {
using namespace internal;
namespace {

// The functions of <cctype> depend on the locale.
constexpr bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
constexpr bool is_letter(char c) { return upper(c) >= 'A' && upper(c) <= 'Z'; }

class WktReader {
 public:
  explicit WktReader(std::string_view text) : begin_(text.data()), at_(begin_), end_(begin_ + text.size()) {}

  RegionSet read() {
    skip_srid();
    geometry(0);
    (void)accepts(';');
    skip_spaces();
    if (at_ != end_) fail("text follows the geometry; only one geometry is read");
    return collector_.take();
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { fail(what, at_); }
  [[noreturn]] void fail(const std::string& what, const char* where) const {
    throw_at_byte(ErrorCode::bad_wkt, "not WKT of polygons: " + what, byte(where));
  }
  std::size_t byte(const char* where) const { return static_cast<std::size_t>(where - begin_); }

  void skip_spaces() {
    while (at_ != end_ && is_space(*at_)) ++at_;
  }
  bool accepts(char c) {
    skip_spaces();
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }
  void expect(char c, const char* what) {
    if (!accepts(c)) fail(std::string("expected '") + c + "' " + what);
  }
  bool accepts_word(std::string_view word) {
    const char* const before = at_;
    if (this->word() == word) return true;
    at_ = before;
    return false;
  }
  /// Reads a word and returns it in capitals; empty if there is none. A word that is too long to be known is cut off.
  std::string word() {
    skip_spaces();
    std::string letters;
    constexpr std::size_t longest = sizeof "GEOMETRYCOLLECTIONZM";
    for (; at_ != end_ && is_letter(*at_) && letters.size() < longest; ++at_) letters += upper(*at_);
    return letters;
  }

  void skip_srid() {
    if (!accepts_word("SRID")) return;
    expect('=', "after SRID");
    skip_spaces();
    unsigned srid = 0;
    const auto [after, error] = std::from_chars(at_, end_, srid);
    if (error != std::errc()) fail("expected a number after SRID=");
    at_ = after;
    expect(';', "after the SRID");
  }

  /// Reads the dimensions between the type and the contents. `suffix`: the dimensions that are joined to the type.
  void dimensions(std::string suffix) {
    const char* const before = at_;
    if (suffix.empty()) suffix = word();
    least_numbers_ = most_numbers_ = suffix == "ZM" ? 4 : 3;
    if (suffix == "Z" || suffix == "M" || suffix == "ZM") return;
    at_ = before;
    least_numbers_ = 2, most_numbers_ = 4;
  }

  void geometry(int depth) {
    skip_spaces();
    const char* const where = at_;
    const std::string type = word();
    const auto is = [&](std::string_view name) {
      if (!type.starts_with(name)) return false;
      const std::string suffix = type.substr(name.size());
      if (!suffix.empty() && suffix != "Z" && suffix != "M" && suffix != "ZM") return false;
      dimensions(suffix);
      return true;
    };
    if (is("POLYGON")) return polygon();
    if (is("MULTIPOLYGON")) return list([this] { polygon(); });
    if (!is("GEOMETRYCOLLECTION")) fail("expected POLYGON, MULTIPOLYGON or GEOMETRYCOLLECTION", where);
    if (depth == deepest_collection)
      fail("collections are nested more than " + std::to_string(deepest_collection) + " levels deep", where);
    list([this, depth] { geometry(depth + 1); });
  }

  /// Reads EMPTY, or items in parentheses.
  template <class Item>
  void list(const Item& item) {
    if (accepts_word("EMPTY")) return;
    expect('(', "or EMPTY");
    do {
      steps_();
      item();
    } while (accepts(','));
    expect(')', "or ','");
  }

  void polygon() {
    collector_.begin_polygon();
    list([this] {
      list([this] { point(); });
      collector_.end_ring();
    });
    collector_.end_polygon();
  }

  void point() {
    const double x = coordinate(), y = coordinate();
    int numbers = 2;
    for (; numbers < most_numbers_ && begins_number(); ++numbers) (void)number();
    if (numbers < least_numbers_) fail("expected " + std::to_string(least_numbers_) + " numbers per point");
    // All points of a geometry have as many numbers as the first: one with more lacks a comma, most likely.
    least_numbers_ = most_numbers_ = numbers;
    collector_.add({x, y});
  }

  bool begins_number() {
    skip_spaces();
    return at_ != end_ && *at_ != ',' && *at_ != ')';
  }

  double coordinate() {
    skip_spaces();
    const std::size_t place = byte(at_);
    return checked_coordinate(number(), place);
  }

  double number() {
    skip_spaces();
    const char* const first = at_ != end_ && *at_ == '+' ? at_ + 1 : at_;
    double value = 0;
    const auto [after, error] = std::from_chars(first, end_, value);
    if (error == std::errc::result_out_of_range)
      throw_at_byte(ErrorCode::out_of_domain, "the number is too large or too small for a double", byte(at_));
    if (error != std::errc() || (first != at_ && *first == '-')) fail("expected a number");
    if (after != end_ && !is_space(*after) && *after != ',' && *after != ')') fail("expected a number");
    at_ = after;
    return value;
  }

  const char* begin_;
  const char* at_;
  const char* end_;
  int least_numbers_ = 2, most_numbers_ = 4;  ///< of a point of the current geometry
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
  return public_call(options, 0, [&](Control&) { return WktReader(text).read(); });
}

std::string to_wkt(const RegionView& regions, const CallOptions& options) {
  return public_call(options, regions.points.size(), [&](Control&) {
    validate(regions, 0);
    return WktWriter().write(regions);
  });
}

}  // namespace oblast
