// Reads Well-Known Text (OGC 06-103r4, section 7) in one pass over the characters.
//
// Accepted beyond the standard: rings that are not closed, EWKT's "SRID=4326;" and its vertices of three or four
// numbers without Z and M after the type, semicolons after a geometry, and lower case.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

#include "io/layer_builder.h"
#include "io/read.h"
#include "io/srid.h"

namespace oblast::io {

namespace {

class WktParser {
 public:
  WktParser(const std::string& text, const std::string& name, Layer& layer, const ReadOptions& options)
      : begin_(text.data()),
        at_(begin_),
        end_(begin_ + text.size()),
        line_start_(begin_),
        name_(name),
        srid_(name),
        builder_(layer, 0, options) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (text.starts_with(byte_order_mark)) at_ += byte_order_mark.size();
  }

  void parse() {
    std::int64_t feature = 0;
    for (; skip_separators(); ++feature) {
      line_ += static_cast<std::size_t>(std::count(line_start_, at_, '\n'));
      line_start_ = at_;
      if (srid_.add(read_srid(), fmt::format("line {}", line_))) builder_.set_crs(srid_.wkt());
      builder_.begin_feature(feature, fmt::format("line {}", line_));
      geometry();
      builder_.end_feature();
    }
    if (feature == 0) builder_.set_crs({});
    builder_.finish();
  }

 private:
  struct Type {
    std::string name;  // upper case, without Z and M
    bool z = false;
    bool m = false;
  };

  // One geometry with all its members. A counter follows the nesting of collections, so there is no recursion.
  void geometry() {
    std::size_t depth = 0;
    for (;;) {
      const Type type = read_type();
      numbers_ = type.z || type.m ? 2 + type.z + type.m : 0;
      if (type.z) builder_.with_z();
      if (type.m) builder_.with_m();
      if (type.name == "GEOMETRYCOLLECTION") {
        if (!read_empty()) {
          expect('(');
          ++depth;
          continue;
        }
      } else {
        simple_geometry(type);
      }
      while (depth > 0 && accept(')')) --depth;
      if (depth == 0) return;
      expect(',');
    }
  }

  void simple_geometry(const Type& type) {
    if (type.name == "POLYGON") {
      if (!read_empty()) polygon(type);
    } else if (type.name == "MULTIPOLYGON") {
      if (read_empty()) return;
      expect('(');
      do {
        if (!read_empty()) polygon(type);
      } while (accept(','));
      expect(')');
    } else if (type.name == "LINESTRING" || type.name == "MULTILINESTRING") {
      if (builder_.keeps_others()) return lines(type);
      builder_.line(type.name);
      skip_body();
    } else if (type.name == "POINT" || type.name == "MULTIPOINT") {
      if (builder_.keeps_others()) return points(type);
      builder_.point(type.name);
      skip_body();
    } else if (is_curve(type.name)) {
      builder_.refuse(type.name + " is a curve type: only straight edges are read; convert it to POLYGON first");
    } else if (type.name == "TIN" || type.name == "TRIANGLE" || type.name == "POLYHEDRALSURFACE") {
      builder_.refuse(type.name + " is not a polygon of the plane");
    } else {
      at_ = type_start_;
      fail("unknown geometry type " + type.name);
    }
  }

  static bool is_curve(const std::string& name) {
    constexpr const char* curves[] = {"CIRCULARSTRING", "COMPOUNDCURVE", "CURVEPOLYGON", "MULTICURVE",
                                      "MULTISURFACE",   "CURVE",         "SURFACE"};
    return std::find(std::begin(curves), std::end(curves), name) != std::end(curves);
  }

  void polygon(const Type& type) {
    builder_.begin_polygon();
    expect('(');
    do {
      ring_.clear();
      if (!read_empty()) ring(type);
      builder_.add_ring(ring_);
    } while (accept(','));
    expect(')');
    builder_.end_polygon();
  }

  void ring(const Type& type) {
    expect('(');
    do {
      vertex(type);
    } while (accept(','));
    expect(')');
  }

  void vertex(const Type& type) {
    const double x = number();
    const double y = number();
    ring_.push_back({x, y});
    const int more = further_numbers();
    if (more == 2 || (more == 1 && !type.m)) builder_.with_z();
    if (more == 2 || (more == 1 && type.m)) builder_.with_m();
  }

  // One line, or several in parentheses.
  void lines(const Type& type) {
    if (read_empty()) return;
    const bool several = type.name == "MULTILINESTRING";
    if (several) expect('(');
    do {
      ring_.clear();
      if (!several || !read_empty()) ring(type);
      builder_.add_line(ring_);
    } while (several && accept(','));
    if (several) expect(')');
  }

  // Several points may each have parentheses, or not.
  void points(const Type& type) {
    if (read_empty()) return;
    expect('(');
    do {
      if (read_empty()) continue;
      ring_.clear();
      const bool in_parentheses = accept('(');
      vertex(type);
      if (in_parentheses) expect(')');
      builder_.add_point(ring_.back());
    } while (type.name == "MULTIPOINT" && accept(','));
    expect(')');
  }

  // All vertices of a geometry have as many numbers as its type says, or else as its first vertex has. A vertex with
  // more lacks a comma, most likely.
  int further_numbers() {
    constexpr int most = 4;
    constexpr const char* words[] = {"none", "one", "two", "three", "four"};
    const int allowed = numbers_ > 0 ? numbers_ : most;
    int numbers = 2;
    for (; !next_is(',') && !next_is(')') && at_ != end_; ++numbers) {
      if (numbers == allowed)
        fail(fmt::format("a vertex has more than {} numbers; is a comma missing before this one?", words[allowed]));
      number();
    }
    if (numbers < numbers_)
      fail(fmt::format("a vertex has {} numbers; {} were expected", words[numbers], words[numbers_]));
    numbers_ = numbers;
    return numbers - 2;
  }

  double number() {
    skip_space();
    const char* from = at_ != end_ && *at_ == '+' ? at_ + 1 : at_;
    double value = 0;
    const auto [after, error] = std::from_chars(from, end_, value);
    if (error == std::errc::invalid_argument) fail("expected a number");
    if (error == std::errc::result_out_of_range) fail("the number is outside the range of a double");
    if (after != end_ && !is_space(*after) && *after != ',' && *after != ')') fail("expected a number");
    at_ = after;
    return value;
  }

  // "POLYGON", "POLYGON ZM", "POLYGONZ"
  Type read_type() {
    skip_space();
    type_start_ = at_;
    Type type;
    type.name = word();
    std::string dimension;
    if (type.name != "EMPTY") {
      const char* const back = at_;
      dimension = word();
      if (dimension != "Z" && dimension != "M" && dimension != "ZM") {
        dimension.clear();
        at_ = back;
      }
    }
    if (dimension.empty()) {
      for (const char* suffix : {"ZM", "Z", "M"}) {
        if (type.name.ends_with(suffix)) {
          dimension = suffix;
          type.name.resize(type.name.size() - dimension.size());
          break;
        }
      }
    }
    if (type.name.empty()) {
      at_ = type_start_;
      fail("expected the name of a geometry type");
    }
    type.z = dimension.find('Z') != std::string::npos;
    type.m = dimension.find('M') != std::string::npos;
    return type;
  }

  std::string word() {
    skip_space();
    std::string result;
    while (at_ != end_ && std::isalpha(static_cast<unsigned char>(*at_))) {
      result += static_cast<char>(std::toupper(static_cast<unsigned char>(*at_++)));
    }
    return result;
  }

  bool read_empty() {
    const char* const back = at_;
    if (word() == "EMPTY") return true;
    at_ = back;
    return false;
  }

  // Skips the body of a geometry: EMPTY or balanced parentheses.
  void skip_body() {
    if (read_empty()) return;
    expect('(');
    for (std::size_t depth = 1; depth > 0; ++at_) {
      if (at_ == end_) fail("a parenthesis is not closed");
      if (*at_ == '(') ++depth;
      if (*at_ == ')') --depth;
    }
  }

  // Moves to the next geometry; false at the end of the text.
  bool skip_separators() {
    for (;;) {
      skip_space();
      if (at_ == end_) return false;
      if (*at_ != ';') return true;
      ++at_;
    }
  }

  // The number in EWKT's "SRID=4326;", or 0.
  unsigned read_srid() {
    const char* const back = at_;
    if (word() != "SRID") {
      at_ = back;
      return 0;
    }
    expect('=');
    skip_space();
    unsigned srid = 0;
    const auto [after, error] = std::from_chars(at_, end_, srid);
    if (error != std::errc()) fail("expected a number after SRID=");
    at_ = after;
    expect(';');
    return srid;
  }

  static bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

  void skip_space() {
    while (at_ != end_ && is_space(*at_)) ++at_;
  }

  bool next_is(char c) {
    skip_space();
    return at_ != end_ && *at_ == c;
  }

  bool accept(char c) {
    if (!next_is(c)) return false;
    ++at_;
    return true;
  }

  void expect(char c) {
    if (!accept(c)) fail(fmt::format("expected '{}'", c));
  }

  [[noreturn]] void fail(const std::string& what) {
    skip_space();
    const auto line = 1 + std::count(begin_, at_, '\n');
    const char* start = at_;
    while (start != begin_ && start[-1] != '\n') --start;
    throw IoError(fmt::format("{}, line {}, column {}: {}{}", name_, line, at_ - start + 1, what,
                              at_ == end_ ? ", found the end of the text" : ""));
  }

  const char* begin_;
  const char* at_;
  const char* end_;
  const char* line_start_;
  const char* type_start_ = nullptr;
  std::size_t line_ = 1;
  int numbers_ = 0;  // of each vertex of the geometry; 0: not known yet
  const std::string& name_;
  CommonSrid srid_;
  LayerBuilder builder_;
  std::vector<Point> ring_;
};

}  // namespace

Layer read_wkt(const std::string& text, const std::string& name, const ReadOptions& options) {
  Layer layer;
  layer.files.push_back(name);
  WktParser(text, name, layer, options).parse();
  return layer;
}

}  // namespace oblast::io
