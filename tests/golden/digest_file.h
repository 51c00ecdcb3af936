// Files of digests: one line an input, "name input result", sorted by name; lines with # in front say what they are.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace oblast::golden {

/// Of one input: what it is, and what the library made of it.
struct InputAndResult {
  std::uint64_t input = 0;
  std::uint64_t result = 0;
  friend bool operator==(const InputAndResult&, const InputAndResult&) = default;
};

using Digests = std::map<std::string, InputAndResult>;

std::string to_text(const Digests& digests);
/// Throws std::runtime_error that quotes the line at fault.
Digests parse_digests(const std::string& text);

}  // namespace oblast::golden
