// The grammar of Well-Known Text (OGC 06-103r4, section 7; EWKT as PostGIS writes it), for the library and the program.
// What becomes of the geometries, and of errors, is decided by a handler.
//
// Accepted beyond the standard: rings that are not closed, EWKT's "SRID=4326;" and its vertices of three or four
// numbers without Z and M after the type, semicolons after a geometry, and small letters.
#pragma once

#include <oblast/point.h>

#include <cstddef>
#include <string>
#include <string_view>

#include "text/wkt_cursor.h"

namespace oblast::text {

struct WktType {
  std::string name;  ///< in capitals, without Z and M
  bool z = false, m = false;
};

struct WktVertex {
  Point at;
  int further = 0;  ///< numbers after x and y
  std::size_t x_byte = 0, y_byte = 0;
};

/// Reads one geometry after the other, in one pass over the characters and without recursion. A handler has:
///
///   bool enter(const WktType&, std::size_t depth, std::size_t byte)
///     A geometry, or a member of a collection, begins. False: its contents are passed over. It must be false for, or
///     throw at, any type but POLYGON, LINESTRING, POINT, their MULTI types, and GEOMETRYCOLLECTION.
///   void begin_polygon(), end_ring(), end_polygon(), end_line(), end_point()
///   void vertex(const WktVertex&)           of the current ring, line or point
///   void poll()                             now and then
///   [[noreturn]] void fail(const std::string& what, std::size_t byte)
///   [[noreturn]] void beyond_double(std::size_t byte)    the number there is too large or too small
template <class Handler>
class WktScanner {
 public:
  WktScanner(std::string_view text, Handler& handler) : text_(text, handler), handler_(handler) {}

  std::size_t byte() const { return text_.byte(); }

  /// Goes on to the next geometry; false at the end of the text.
  bool find_next() {
    while (text_.accepts(';')) {
    }
    return !text_.is_at_end();
  }
  bool accepts(char c) { return text_.accepts(c); }

  /// The number in EWKT's "SRID=4326;", or 0.
  unsigned srid() {
    if (!text_.accepts_word("SRID")) return 0;
    text_.expect('=', "after SRID");
    const unsigned srid = text_.natural("after SRID=");
    text_.expect(';', "after the SRID");
    return srid;
  }

  /// One geometry with all its members.
  void geometry() {
    std::size_t depth = 0;  // of collections that are open
    for (;;) {
      text_.skip_spaces();
      const std::size_t where = text_.byte();
      const WktType type = this->type();
      numbers_ = type.z || type.m ? 2 + type.z + type.m : 0;
      if (!handler_.enter(type, depth, where)) {
        skip_contents();
      } else if (type.name != "GEOMETRYCOLLECTION") {
        contents(type.name);
      } else if (!text_.accepts_word("EMPTY")) {
        text_.expect('(', "or EMPTY");
        ++depth;
        continue;
      }
      while (depth > 0 && text_.accepts(')')) --depth;
      if (depth == 0) return;
      text_.expect(',', "or ')'");
    }
  }

 private:
  /// "POLYGON", "POLYGON ZM", "POLYGONZ"
  WktType type() {
    WktType type;
    type.name = text_.word();
    if (type.name.empty()) text_.fail("expected the name of a geometry type");
    std::string dimension;
    for (const char* suffix : {"ZM", "Z", "M"}) {
      if (!dimension.empty() || !type.name.ends_with(suffix)) continue;
      dimension = suffix;
      type.name.resize(type.name.size() - dimension.size());
    }
    for (const char* words : {"ZM", "Z", "M"})
      if (dimension.empty() && text_.accepts_word(words)) dimension = words;
    type.z = dimension.starts_with('Z');
    type.m = dimension.ends_with('M');
    return type;
  }

  void contents(const std::string& type) {
    if (type == "POLYGON") {
      polygon();
    } else if (type == "MULTIPOLYGON") {
      list([this] { polygon(); });
    } else if (type == "LINESTRING") {
      if (!text_.accepts_word("EMPTY")) line();
    } else if (type == "MULTILINESTRING") {
      list([this] { line(); });
    } else if (type == "POINT") {
      if (!text_.accepts_word("EMPTY")) point();
    } else {
      list([this] {  // of points each of which has parentheses, or not
        if (!text_.accepts_word("EMPTY")) text_.begins_with('(') ? point() : bare_point();
      });
    }
  }

  /// EMPTY, or items in parentheses.
  template <class Item>
  void list(const Item& item) {
    if (text_.accepts_word("EMPTY")) return;
    text_.expect('(', "or EMPTY");
    do {
      handler_.poll();
      item();
    } while (text_.accepts(','));
    text_.expect(')', "or ','");
  }

  void polygon() {
    if (text_.accepts_word("EMPTY")) return;
    handler_.begin_polygon();
    list([this] {
      list([this] { vertex(); });
      handler_.end_ring();
    });
    handler_.end_polygon();
  }
  void line() {
    list([this] { vertex(); });
    handler_.end_line();
  }
  void point() {
    text_.expect('(', "or EMPTY");
    bare_point();
    text_.expect(')', "after the point");
  }
  void bare_point() {
    vertex();
    handler_.end_point();
  }

  /// All vertices of a geometry have as many numbers as its type says, or else as its first one has. A vertex with more
  /// lacks a comma, most likely.
  void vertex() {
    constexpr const char* words[] = {"none", "one", "two", "three", "four"};
    WktVertex vertex;
    text_.skip_spaces();
    vertex.x_byte = text_.byte();
    vertex.at.x = text_.number();
    text_.skip_spaces();
    vertex.y_byte = text_.byte();
    vertex.at.y = text_.number();
    const int allowed = numbers_ > 0 ? numbers_ : 4;  // x, y, Z and M
    int numbers = 2;
    for (; !text_.begins_with(',') && !text_.begins_with(')') && !text_.is_at_end(); ++numbers) {
      if (numbers == allowed)
        text_.fail(std::string("a vertex has more than ") + words[allowed] +
                   " numbers; is a comma missing before this one?");
      (void)text_.number();
    }
    if (numbers < numbers_)
      text_.fail(std::string("a vertex has ") + words[numbers] + " numbers; " + words[numbers_] + " were expected");
    numbers_ = numbers;
    vertex.further = numbers - 2;
    handler_.vertex(vertex);
  }

  /// Passes over EMPTY or balanced parentheses.
  void skip_contents() {
    if (text_.accepts_word("EMPTY")) return;
    text_.expect('(', "or EMPTY");
    text_.skip_to_closing();
  }

  WktCursor<Handler> text_;
  int numbers_ = 0;  ///< of each vertex of the geometry; 0: not known yet
  Handler& handler_;
};

}  // namespace oblast::text
