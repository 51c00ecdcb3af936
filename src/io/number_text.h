// Numbers as text: the shortest digits that read back to the same bits.
#pragma once

#include <charconv>
#include <string>

namespace oblast::io {

inline void append_number(std::string& text, double value) {
  char digits[32];  // the longest shortest form has 24 characters
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
  text.append(digits, end);
}

}  // namespace oblast::io
