// The floating-point environment that exact arithmetic requires, whatever other code of the process has set.
//
// Expansions and filters are right if every operation is rounded to nearest and no small number is replaced by 0. Code
// built with -ffast-math sets flush-to-zero and denormals-are-zero when it is loaded. Other code changes the rounding
// mode or enables traps. Each of these breaks the predicates silently. So a call sets the default on every thread that
// works for it, and restores the previous environment at the end: modes, traps and flags.
//
// The compiler does not know that arithmetic depends on the environment. Reading and writing it are memory barriers, so
// computations from memory to memory stay between them. For computations in registers, the function must not be inlined
// (public_call.h).
#pragma once

#if !defined(__SSE2__) && !defined(__aarch64__)
#include <cfenv>
#endif

#include <cstdint>

#include "base/arithmetic.h"

namespace oblast::internal {

#if defined(__SSE2__)

/// The register MXCSR. Nothing is computed in x87 registers.
class FloatingPoint {
 public:
  /// Rounding to nearest, no traps, no small number replaced by 0.
  static FloatingPoint default_modes() { return FloatingPoint(0x1f80); }
  static FloatingPoint current() {
    std::uint32_t word;
    asm volatile("stmxcsr %0" : "=m"(word) : : "memory");
    return FloatingPoint(word);
  }
  void set() const { asm volatile("ldmxcsr %0" : : "m"(word_) : "memory"); }

  /// Compares everything except the status flags.
  bool same_modes(const FloatingPoint& o) const { return ((word_ ^ o.word_) & ~std::uint32_t{0x3f}) == 0; }
  friend bool operator==(const FloatingPoint&, const FloatingPoint&) = default;

 private:
  explicit FloatingPoint(std::uint32_t word) : word_(word) {}

  std::uint32_t word_;
};

#elif defined(__aarch64__)

/// The registers FPCR (modes) and FPSR (flags).
class FloatingPoint {
 public:
  static FloatingPoint default_modes() { return FloatingPoint(0, 0); }
  static FloatingPoint current() {
    std::uint64_t control, status;
    asm volatile("mrs %0, fpcr" : "=r"(control) : : "memory");
    asm volatile("mrs %0, fpsr" : "=r"(status) : : "memory");
    return FloatingPoint(control, status);
  }
  void set() const {
    asm volatile("msr fpcr, %0" : : "r"(control_) : "memory");
    asm volatile("msr fpsr, %0" : : "r"(status_) : "memory");
  }

  bool same_modes(const FloatingPoint& o) const { return control_ == o.control_; }
  friend bool operator==(const FloatingPoint&, const FloatingPoint&) = default;

 private:
  FloatingPoint(std::uint64_t control, std::uint64_t status) : control_(control), status_(status) {}

  std::uint64_t control_, status_;
};

#else

/// With <cfenv>. Environments cannot be compared, so the environment is always set.
class FloatingPoint {
 public:
  static FloatingPoint default_modes() { return FloatingPoint(true); }
  static FloatingPoint current() {
    FloatingPoint found(false);
    std::fegetenv(&found.environment_);
    return found;
  }
  void set() const { std::fesetenv(is_default_ ? FE_DFL_ENV : &environment_); }

  bool same_modes(const FloatingPoint&) const { return false; }
  friend bool operator==(const FloatingPoint&, const FloatingPoint&) { return false; }

 private:
  explicit FloatingPoint(bool is_default) : is_default_(is_default) {}

  bool is_default_;
  std::fenv_t environment_{};
};

#endif

/// While it exists, this thread has the modes of `wanted`. Then it restores everything, including flags. Cost: two
/// reads of a register, and two writes if the modes differ.
class WithFloatingPoint {
 public:
  explicit WithFloatingPoint(const FloatingPoint& wanted = FloatingPoint::default_modes())
      : found_(FloatingPoint::current()) {
    if (!found_.same_modes(wanted)) wanted.set();
  }
  WithFloatingPoint(const WithFloatingPoint&) = delete;
  WithFloatingPoint& operator=(const WithFloatingPoint&) = delete;
  ~WithFloatingPoint() {
    if (FloatingPoint::current() != found_) found_.set();
  }

  const FloatingPoint& found() const { return found_; }

 private:
  FloatingPoint found_;
};

/// The same with the default modes, but the flags are not restored. For work of some ten nanoseconds without a Call
/// (Locator::locate of one point), in which reading the flags again takes a third of the time.
class WithDefaultModes {
 public:
  WithDefaultModes() : found_(FloatingPoint::current()) {
    differ_ = !found_.same_modes(FloatingPoint::default_modes());
    if (differ_) FloatingPoint::default_modes().set();
  }
  WithDefaultModes(const WithDefaultModes&) = delete;
  WithDefaultModes& operator=(const WithDefaultModes&) = delete;
  ~WithDefaultModes() {
    if (differ_) found_.set();
  }

 private:
  FloatingPoint found_;
  bool differ_;
};

}  // namespace oblast::internal
