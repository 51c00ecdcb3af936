// 32-bit indices: the one that stands for nothing, and counts that become indices.
#pragma once

#include <oblast/error.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "base/index_limits.h"

namespace oblast::internal {

/// In place of an index: there is none. It is above all indices that are allowed (base/index_limits.h).
inline constexpr std::uint32_t none = 0xffffffff;
static_assert(most_indices < none);

[[noreturn, gnu::cold, gnu::noinline]] inline void throw_too_many(const char* what, std::size_t most,
                                                                  std::size_t operand = Place::npos) {
  throw Error(ErrorCode::too_large, std::string("too large: more than ") + std::to_string(most) + ' ' + what,
              {operand});
}

/// Throws Error(too_large), whose message says what there are too many of, if `count` is more than `most`.
inline void check_count(std::size_t count, const char* what, std::size_t most = most_indices) {
  if (count > most) [[unlikely]]
    throw_too_many(what, most);
}

/// The count as the index past the last element. Throws as check_count.
inline std::uint32_t checked_index(std::size_t count, const char* what, std::size_t most = most_indices) {
  check_count(count, what, most);
  return static_cast<std::uint32_t>(count);
}

}  // namespace oblast::internal
