// Files of digests: one line per input, "name input result", sorted by name. Lines that begin with # are comments.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace oblast::golden {

/// The digests of one input and of its result.
struct InputAndResult {
  std::uint64_t input = 0;
  std::uint64_t result = 0;
  friend bool operator==(const InputAndResult&, const InputAndResult&) = default;
};

using Digests = std::map<std::string, InputAndResult>;

std::string to_text(const Digests& digests);
/// Throws std::runtime_error, whose message quotes the faulty line.
Digests parse_digests(const std::string& text);

}  // namespace oblast::golden
