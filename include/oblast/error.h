// What the library reports: data or options at fault, a call that was cancelled, one that needs more than it may have.
#pragma once

#include <oblast/export.h>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace oblast {

enum class ErrorCode {
  not_finite,     ///< a coordinate is NaN or infinite
  out_of_domain,  ///< a coordinate's magnitude is outside the domain (see domain.h)
  too_large,      ///< more than 2^31 - 1 vertices in one call or its result, or more crossings than have 32-bit indices
  bad_offsets,    ///< contour_ends or polygon_ends decrease or run past the end
  bad_option,     ///< an option contradicts another or is out of range
  precondition,   ///< the input is outside the stated domain of a classic method
  cancelled,      ///< the caller's callback asked to stop
  memory_limit,   ///< the call needs more memory than CallOptions::most_bytes
  bad_wkt,        ///< text that is not Well-Known Text of polygons
  bad_wkb,        ///< bytes that are not Well-Known Binary of polygons
};

/// Where in the input an error is: indices into the arrays of the operand, or bytes of what is read. `npos` where it
/// does not apply.
struct Place {
  static constexpr std::size_t npos = static_cast<std::size_t>(-1);
  std::size_t operand = npos;  ///< 0 for A, 1 for B
  std::size_t polygon = npos;
  std::size_t contour = npos;  ///< index of the contour within the operand
  std::size_t vertex = npos;   ///< index of the vertex within the contour
  std::size_t byte = npos;     ///< of text or binary that is read: how many bytes come before the fault
};

/// Thrown by the public functions. Degenerate geometry never is an error (promise G5).
class OBLAST_API Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& what, Place place = {})
      : std::runtime_error(what), code_(code), place_(place) {}

  ErrorCode code() const { return code_; }
  const Place& place() const { return place_; }

 private:
  ErrorCode code_;
  Place place_;
};

}  // namespace oblast
