// The errors that the library reports: faulty data or options, a cancelled call, a call above its memory limit.
#pragma once

#include <oblast/export.h>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace oblast {

enum class ErrorCode {
  not_finite,     ///< a coordinate is NaN or infinite
  out_of_domain,  ///< a coordinate's magnitude is outside the domain (see domain.h)
  too_large,      ///< more than 2^31 - 1 vertices in a call or its result, or more crossings than 32-bit indices allow
  bad_offsets,    ///< contour_ends or polygon_ends decrease, or do not end at the count that they divide
  bad_option,     ///< an option or an enumerator is out of range
  precondition,   ///< the input is outside the domain that the function states
  cancelled,      ///< CallOptions::progress returned false
  memory_limit,   ///< the call needs more memory than CallOptions::most_bytes
  bad_wkt,        ///< text that is not Well-Known Text of polygons
  bad_wkb,        ///< bytes that are not Well-Known Binary of polygons
};

/// Where in the input the error is: indices into the arrays of the operand, or a byte of the text or binary that is
/// read. An index that does not apply is `npos`.
struct Place {
  static constexpr std::size_t npos = static_cast<std::size_t>(-1);
  std::size_t operand = npos;  ///< 0 for A, 1 for B
  std::size_t polygon = npos;
  std::size_t contour = npos;  ///< index of the contour within the operand
  std::size_t vertex = npos;   ///< index of the vertex within the contour
  std::size_t byte = npos;     ///< number of bytes before the fault, in text or binary that is read
  std::size_t feature = npos;  ///< index of the feature, where the operand has features
};

/// The exception of all public functions. Degenerate geometry is never an error of an overlay (promise G5).
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
