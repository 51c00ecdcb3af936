// UTF-8 by hand: five lines of rules; see picture_text.h.
#include "io/picture_text.h"

#include <algorithm>

namespace oblast::io {

namespace {

constexpr const char* replacement = "\xEF\xBF\xBD";
constexpr const char* ellipsis = "\xE2\x80\xA6";
constexpr double wide_character = 0.53;  // of the font size, on average in a sans-serif font

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

// The length of the valid sequence that begins at `at`; 0 if there is none (Unicode 15, table 3-7).
std::size_t sequence_at(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = byte(at), second = byte(at + 1);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xc2 && first <= 0xdf   ? 2
                             : (first & 0xf0) == 0xe0         ? 3
                             : first >= 0xf0 && first <= 0xf4 ? 4
                                                              : 0;
  if (length == 0) return 0;
  if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f)) return 0;
  if ((first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f)) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if (at + i >= text.size() || !continues(text[at + i])) return 0;
  return length;
}

std::size_t characters(const std::string& text) {
  std::size_t count = 0;
  for (const char c : text) count += !continues(c);
  return count;
}

std::string beginning(const std::string& text, std::size_t count) {
  std::size_t at = 0;
  for (; at < text.size(); ++at)
    if (!continues(text[at]) && count-- == 0) break;
  return text.substr(0, at);
}

}  // namespace

std::string readable(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = sequence_at(text, at);
    if (length == 0) {
      result += replacement;
      ++at;
      continue;
    }
    if (length == 1 && (static_cast<unsigned char>(text[at]) < 0x20 || text[at] == 0x7f)) {
      result += ' ';
    } else if (length == 3 && text.compare(at, 2, "\xEF\xBF") == 0 &&
               static_cast<unsigned char>(text[at + 2]) >= 0xbe) {
      result += replacement;  // U+FFFE and U+FFFF are no characters of XML
    } else {
      result.append(text, at, length);
    }
    at += length;
  }
  return result;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

double text_width(const std::string& text, double font_size) {
  return wide_character * font_size * static_cast<double>(characters(text));
}

std::string fitted(const std::string& text, double font_size, double width) {
  if (text_width(text, font_size) <= width) return text;
  const double count = width / (wide_character * font_size) - 1;
  return beginning(text, count > 0 ? static_cast<std::size_t>(count) : 0) + ellipsis;
}

std::vector<std::string> wrapped(const std::string& text, double font_size, double width, std::size_t most) {
  std::vector<std::string> lines{""};
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at), line = lines.back().empty() ? word : lines.back() + " " + word;
    if (text_width(line, font_size) <= width || lines.back().empty()) {
      lines.back() = line;
    } else if (lines.size() < most) {
      lines.push_back(word);
    } else {
      lines.back() += " " + text.substr(at);
      break;
    }
    at = end + 1;
  }
  for (std::string& line : lines) line = fitted(line, font_size, width);
  return lines;
}

std::string counted_in_picture(std::uint64_t number, const std::string& noun, const std::string& plural) {
  std::string digits = std::to_string(number);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
  return digits + " " + (number == 1 ? noun : plural);
}

}  // namespace oblast::io
