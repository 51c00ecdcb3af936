// WKT of region sets, unchanged.
#include "generators/wkt.h"

#include <charconv>
#include <stdexcept>

#include "generators/soup.h"

namespace oblast::generators {
namespace {

void append(std::string& text, double value) {
  char buffer[32];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

// Reads nested lists of coordinates; `at_` moves along the text.
class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text), at_(text_.c_str()) {}

  RegionSet read() {
    const bool many = skip_word("MULTIPOLYGON");
    if (!many && !skip_word("POLYGON")) fail("POLYGON or MULTIPOLYGON");
    if (!skip_word("EMPTY")) {
      if (many) {
        list([this] { polygon(); });
      } else {
        polygon();
      }
    }
    skip_space();
    if (*at_ != 0) fail("nothing more");
    return std::move(soup_);
  }

 private:
  [[noreturn]] void fail(const std::string& wanted) const {
    throw std::invalid_argument("expected " + wanted + " at: " + std::string(at_).substr(0, 40));
  }

  void skip_space() {
    while (*at_ == ' ') ++at_;
  }

  bool skip_word(const std::string& word) {
    skip_space();
    if (std::string(at_, std::min(word.size(), std::string(at_).size())) != word) return false;
    at_ += word.size();
    return true;
  }

  template <typename Item>
  void list(const Item& item) {
    if (!skip_word("(")) fail("(");
    do item();
    while (skip_word(","));
    if (!skip_word(")")) fail(")");
  }

  double number() {
    skip_space();
    double value = 0;
    const auto [end, error] = std::from_chars(at_, text_.c_str() + text_.size(), value);
    if (error != std::errc()) fail("a number");
    at_ = end;
    return value;
  }

  void polygon() {
    bool first = true;
    list([&] {
      Ring ring;
      list([&] {
        const double x = number();
        ring.push_back({x, number()});
      });
      if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
      first ? add_polygon(soup_, ring) : add_hole(soup_, ring);
      first = false;
    });
  }

  std::string text_;
  const char* at_;
  RegionSet soup_;
};

}  // namespace

RegionSet soup_from_wkt(const std::string& text) { return Reader(text).read(); }

std::string soup_to_wkt(const RegionView& soup) {
  if (soup.points.empty()) return "MULTIPOLYGON EMPTY";
  std::string text = "MULTIPOLYGON (";
  for (std::size_t p = 0; p < soup.polygon_count(); ++p) {
    text += p == 0 ? "(" : ", (";
    for (std::size_t c = soup.polygon_begin(p); c < soup.polygon_end(p); ++c) {
      text += c == soup.polygon_begin(p) ? "(" : ", (";
      const auto contour = soup.contour(c);
      for (std::size_t v = 0; v <= contour.size() && !contour.empty(); ++v) {
        if (v > 0) text += ", ";
        append(text, contour[v % contour.size()].x);
        text += ' ';
        append(text, contour[v % contour.size()].y);
      }
      text += ')';
    }
    text += ')';
  }
  return text + ")";
}

}  // namespace oblast::generators
