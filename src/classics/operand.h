// Operands of the classics: their contours cleaned, and each method's domain checked.
//
// What is outside a method's domain is Error(precondition) with the place and another method to use.
#pragma once

#include <oblast/error.h>
#include <oblast/region_set.h>

#include <cstdint>
#include <span>
#include <string>

#include "base/call_memory.h"

namespace oblast::internal::classics {

/// A contour without repeated neighbours and without its closing point; -0.0 is 0.0.
struct Ring {
  Array<Point> points;
  Array<std::uint32_t> source;  ///< by point: the vertex of the contour as given
  std::size_t contour = 0;      ///< which contour of the operand it was

  std::size_t size() const { return points.size(); }
  const Point& next(std::size_t i) const { return points[i + 1 == points.size() ? 0 : i + 1]; }
  const Point& previous(std::size_t i) const { return points[i == 0 ? points.size() - 1 : i - 1]; }
};

Ring clean_ring(std::span<const Point> contour);
void reverse(Ring& ring);

/// An operand under the eyes of a method: for checks and their messages.
struct Operand {
  const RegionView& regions;
  std::size_t index;    ///< 0 for A, 1 for B
  const char* method;   ///< "O'Rourke"
  const char* instead;  ///< "Weiler-Atherton or overlay"

  /// Throws Error(precondition). `vertex` may be Place::npos, and so may `contour`.
  [[noreturn]] void refuse(const std::string& why, std::size_t contour, std::size_t vertex) const;

  /// The one contour of the operand, at least three different points. Throws Error(precondition).
  Ring one_contour() const;
  /// The one contour of the operand, convex, turned counter-clockwise; straight vertices are allowed. Cost: linear.
  Ring one_convex_contour() const;
  /// All contours, cleaned, as directed.
  Array<Ring> all_contours() const;
};

/// Throws Error(precondition) unless `operation` is one that the method has.
void refuse_symmetric_difference(bool is_symmetric_difference, const char* method);

}  // namespace oblast::internal::classics
