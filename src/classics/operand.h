// The operands of the classics: cleans their contours and checks the domain of each method.
//
// An operand outside the domain of a method is an Error(precondition) with the place and another method to use.
#pragma once

#include <oblast/error.h>
#include <oblast/region_set.h>

#include <cstdint>
#include <span>
#include <string>

#include "base/call_memory.h"

namespace oblast::internal::classics {

/// A contour without repeated neighbours and without its closing point. -0.0 is replaced by 0.0.
struct Ring {
  Array<Point> points;
  Array<std::uint32_t> source;  ///< by point: its vertex in the contour of the input
  std::size_t contour = 0;      ///< the contour of the operand

  std::size_t size() const { return points.size(); }
  const Point& next(std::size_t i) const { return points[i + 1 == points.size() ? 0 : i + 1]; }
  const Point& previous(std::size_t i) const { return points[i == 0 ? points.size() - 1 : i - 1]; }
};

Ring clean_ring(std::span<const Point> contour);
void reverse(Ring& ring);

/// An operand of a method, for checks and their messages.
struct Operand {
  const RegionView& regions;
  std::size_t index;    ///< 0 for A, 1 for B
  const char* method;   ///< "O'Rourke"
  const char* instead;  ///< "Weiler-Atherton or overlay"

  /// Throws Error(precondition). `vertex` may be Place::npos, and so may `contour`.
  [[noreturn]] void refuse(const std::string& why, std::size_t contour, std::size_t vertex) const;

  /// The only contour of the operand, with at least three different points. Throws Error(precondition) otherwise.
  Ring one_contour() const;
  /// The only contour of the operand, made counter-clockwise. Throws Error(precondition) if it is not convex. Cost:
  /// linear.
  Ring one_convex_contour() const;
  /// All contours, cleaned, with their directions. Throws Error(precondition) if one has fewer than three different
  /// points.
  Array<Ring> all_contours() const;
};

/// Throws Error(precondition) for the symmetric difference, which the method does not have.
void refuse_symmetric_difference(bool is_symmetric_difference, const char* method);

}  // namespace oblast::internal::classics
