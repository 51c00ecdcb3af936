// The characters of Well-Known Text: spaces, words and numbers. Places are bytes of the text.
#pragma once

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

namespace oblast::text {

/// `fail` and `beyond_double` of the handler: see WktScanner.
template <class Handler>
class WktCursor {
 public:
  WktCursor(std::string_view text, Handler& handler)
      : begin_(text.data()), at_(begin_), end_(begin_ + text.size()), handler_(handler) {}

  std::size_t byte() const { return static_cast<std::size_t>(at_ - begin_); }

  bool is_at_end() const { return at_ == end_; }

  bool accepts(char c) {
    skip_spaces();
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }

  [[noreturn]] void fail(const std::string& what) {
    skip_spaces();
    handler_.fail(what, byte());
  }

  void skip_spaces() {
    while (at_ != end_ && is_space(*at_)) ++at_;
  }
  void expect(char c, const char* what) {
    if (!accepts(c)) fail(std::string("expected '") + c + "' " + what);
  }

  /// A word in capitals; empty if there is none. A word that is too long to be known is cut off.
  std::string word() {
    skip_spaces();
    std::string letters;
    constexpr std::size_t longest = sizeof "GEOMETRYCOLLECTIONZM";
    for (; at_ != end_ && is_letter(*at_) && letters.size() < longest; ++at_) letters += upper(*at_);
    return letters;
  }
  bool accepts_word(std::string_view wanted) {
    const char* const before = at_;
    if (word() == wanted) return true;
    at_ = before;
    return false;
  }

  bool begins_with(char c) {
    skip_spaces();
    return at_ != end_ && *at_ == c;
  }

  double number() {
    skip_spaces();
    const char* const first = at_ != end_ && *at_ == '+' ? at_ + 1 : at_;
    double value = 0;
    const auto [after, error] = std::from_chars(first, end_, value);
    if (error == std::errc::result_out_of_range) handler_.beyond_double(byte());
    if (error != std::errc() || (first != at_ && *first == '-')) fail("expected a number");
    if (after != end_ && !is_space(*after) && *after != ',' && *after != ')') fail("expected a number");
    at_ = after;
    return value;
  }

  /// A whole number without a sign.
  unsigned natural(const char* place) {
    skip_spaces();
    unsigned value = 0;
    const auto [after, error] = std::from_chars(at_, end_, value);
    if (error != std::errc()) fail(std::string("expected a number ") + place);
    at_ = after;
    return value;
  }

  /// Passes over all to the parenthesis that closes the one before.
  void skip_to_closing() {
    for (std::size_t depth = 1; depth > 0; ++at_) {
      if (at_ == end_) fail("a parenthesis is not closed");
      if (*at_ == '(') ++depth;
      if (*at_ == ')') --depth;
    }
  }

 private:
  // The functions of <cctype> depend on the locale.
  static constexpr bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  static constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
  static constexpr bool is_letter(char c) { return upper(c) >= 'A' && upper(c) <= 'Z'; }

  const char* begin_;
  const char* at_;
  const char* end_;
  Handler& handler_;
};

}  // namespace oblast::text
