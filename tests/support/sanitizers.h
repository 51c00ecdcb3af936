// Whether a sanitizer watches the tests: stacks and memory are then several times what the program takes.
#pragma once

namespace oblast::testing {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool under_sanitizer = true;
#else
inline constexpr bool under_sanitizer = false;
#endif

}  // namespace oblast::testing
