// Floating-point environments that other code of a process may leave behind.
#pragma once

#include <cfenv>
#include <cstdint>
#include <vector>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace oblast::testing {

struct Modes {
  const char* name;
  int rounding;
  bool flush, denormals_are_zero;
};

/// Of this thread. On ARM one bit stands for both ways of replacing subnormal numbers.
inline void set_modes(const Modes& modes) {
  std::fesetround(modes.rounding);
#if defined(__SSE2__)
  constexpr unsigned flush = 1U << 15, denormals_are_zero = 1U << 6;
  unsigned word = _mm_getcsr() & ~(flush | denormals_are_zero);
  if (modes.flush) word |= flush;
  if (modes.denormals_are_zero) word |= denormals_are_zero;
  _mm_setcsr(word);
#elif defined(__aarch64__)
  constexpr std::uint64_t flush = std::uint64_t{1} << 24;
  std::uint64_t word;
  asm volatile("mrs %0, fpcr" : "=r"(word));
  word = modes.flush || modes.denormals_are_zero ? word | flush : word & ~flush;
  asm volatile("msr fpcr, %0" : : "r"(word));
#endif
}

/// The modes of this thread as the processor has them.
inline std::uint64_t processor_modes() {
#if defined(__SSE2__)
  return _mm_getcsr() & ~0x3fU;
#elif defined(__aarch64__)
  std::uint64_t word;
  asm volatile("mrs %0, fpcr" : "=r"(word));
  return word;
#else
  return static_cast<std::uint64_t>(std::fegetround());
#endif
}

inline const Modes usual_modes{"to nearest", FE_TONEAREST, false, false};
inline const std::vector<Modes> all_modes = {
    usual_modes,
    {"flush to zero", FE_TONEAREST, true, false},
    {"denormals are zero", FE_TONEAREST, false, true},
    {"as -ffast-math sets it", FE_TONEAREST, true, true},
    {"upward", FE_UPWARD, false, false},
    {"downward", FE_DOWNWARD, false, false},
    {"toward zero", FE_TOWARDZERO, false, false},
    {"upward, without subnormals", FE_UPWARD, true, true},
};

/// While it lives.
class WithModes {
 public:
  explicit WithModes(const Modes& modes) {
    std::fegetenv(&found_);
    set_modes(modes);
  }
  WithModes(const WithModes&) = delete;
  WithModes& operator=(const WithModes&) = delete;
  ~WithModes() { std::fesetenv(&found_); }

 private:
  std::fenv_t found_;
};

}  // namespace oblast::testing
