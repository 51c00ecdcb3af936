// Reading and writing files of digests.
#include "golden/digest_file.h"

#include <charconv>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace oblast::golden {
namespace {

constexpr std::size_t digits = 16;

void append(std::string& text, std::uint64_t digest) {
  char buffer[digits];
  const auto end = std::to_chars(buffer, buffer + digits, digest, 16).ptr;
  text += ' ';
  text.append(digits - static_cast<std::size_t>(end - buffer), '0');
  text.append(buffer, end);
}

std::uint64_t parse(std::string_view word, const std::string& line) {
  std::uint64_t digest = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), digest, 16);
  if (error != std::errc() || end != word.data() + word.size())
    throw std::runtime_error("not a line of digests: " + line);
  return digest;
}

}  // namespace

std::string to_text(const Digests& digests) {
  std::string text;
  for (const auto& [name, digest] : digests) {
    text += name;
    append(text, digest.input);
    append(text, digest.result);
    text += '\n';
  }
  return text;
}

Digests parse_digests(const std::string& text) {
  Digests digests;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    constexpr std::size_t tail = 2 * (1 + digits);
    if (line.size() <= tail || line[line.size() - tail] != ' ' || line[line.size() - tail / 2] != ' ')
      throw std::runtime_error("not a line of digests: " + line);
    const std::string_view words(line.data() + line.size() - tail, tail);
    digests[line.substr(0, line.size() - tail)] = {parse(words.substr(1, digits), line),
                                                   parse(words.substr(digits + 2, digits), line)};
  }
  return digests;
}

}  // namespace oblast::golden
