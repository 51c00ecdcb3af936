// The classic methods of Skvortsov 2002, section 2: each on its own domain, the same bytes as `overlay`.
//
// Each function checks its domain first and throws Error(precondition) outside it, never gives a wrong
// answer. The error says which contour and which vertex are at fault and which method to use instead; its
// Place has the same as indices. Inside the domain every degenerate meeting (vertex on edge, vertex on
// vertex, shared edges) is decided by exact predicates, and the result is, byte for byte, what
// `overlay` gives.
#pragma once

#include <oblast/error.h>
#include <oblast/export.h>
#include <oblast/options.h>
#include <oblast/region_set.h>

#include <cstdint>
#include <memory>

namespace oblast {

enum class ClassicMethod { orourke, sutherland_hodgman, weiler_atherton, margalit_knott };

/// What a classic did. Filled when a pointer to one is given.
struct ClassicReport {
  std::uint64_t steps = 0;     ///< advances (O'Rourke), half-planes (Sutherland-Hodgman); 0 for the others
  std::uint64_t meetings = 0;  ///< points at which the boundaries of A and B meet
  /// Some meeting lies so close to another vertex or edge (within 2^-46 of the largest coordinate) that
  /// rounding it might change what meets what. The method then hands its operands to the settled noding
  /// of `overlay`, which repeats rounding until nothing changes.
  bool handed_over = false;
};

/// O'Rourke, Chien, Olson and Naddor 1982: convex with convex.
/// Domain: each operand one convex contour, either direction, straight vertices allowed; intersection,
/// union, difference. Cost: at most 2(n1 + n2) advances, O(n1 + n2) time, and O(k log k) to order k meetings.
/// Throws Error: precondition, and as `overlay`.
OBLAST_API RegionSet orourke(const RegionView& a, const RegionView& b, Operation operation,
                             ClassicReport* report = nullptr, const CallOptions& options = {});

/// Sutherland and Hodgman 1974: `subject` clipped to a convex window; intersection only.
/// Domain: the window is one convex contour of m sides; the subject is one general polygon, that is, any
/// contours read by even-odd, or several polygons that meet each other nowhere but at vertices. What
/// crosses itself in the subject is resolved first, since a result must be closed.
/// Cost: O(m n log n) worst, O(m n) where few edges cross the window; O(n log n) to see that the subject is simple.
/// Throws Error: precondition, and as `overlay`.
OBLAST_API RegionSet sutherland_hodgman(const RegionView& subject, const RegionView& window,
                                        ClassicReport* report = nullptr, const CallOptions& options = {});

/// Weiler and Atherton 1977: regular polygons with oriented contours; holes allowed.
/// Domain: in each operand edges meet at their ends only, and the interior is on one and the same side
/// of every contour as it is directed: left of all or right of all. Contours are read as directed, however
/// they are grouped into polygons. Intersection, union, difference. Cost: O((n + k) log n), k meetings.
/// Throws Error: precondition, and as `overlay`.
OBLAST_API RegionSet weiler_atherton(const RegionView& a, const RegionView& b, Operation operation,
                                     ClassicReport* report = nullptr, const CallOptions& options = {});

/// Margalit and Knott 1989: vertex-complete polygons.
/// Domain: each operand one contour, either direction, any two edges of which are disjoint, or meet at
/// their ends only, or coincide: keyholes and figures of eight are admitted. Read by even-odd.
/// Intersection, union, difference. Cost: O((n + k) log n): the improvement Table 1 calls theoretical.
/// Throws Error: precondition, and as `overlay`.
OBLAST_API RegionSet margalit_knott(const RegionView& a, const RegionView& b, Operation operation,
                                    ClassicReport* report = nullptr, const CallOptions& options = {});

/// One of the above by its name. Throws Error(precondition) for an operation the method does not have.
OBLAST_API RegionSet classic(ClassicMethod method, const RegionView& a, const RegionView& b, Operation operation,
                             ClassicReport* report = nullptr, const CallOptions& options = {});

/// A convex window prepared once, to clip millions of polygons. Most of a subject needs a look at its boxes only, so
/// the cost is that of what comes near the window. May be used from several threads at once.
class OBLAST_API ClipWindow {
 public:
  /// The contour of `window`. Domain and errors as the window of `sutherland_hodgman`.
  explicit ClipWindow(const RegionView& window, const CallOptions& options = {});
  /// REQUIRES: x0 < x1, y0 < y1; else throws Error(precondition).
  ClipWindow(double x0, double y0, double x1, double y1);
  ~ClipWindow();
  ClipWindow(ClipWindow&&) noexcept;
  ClipWindow& operator=(ClipWindow&&) noexcept;

  /// overlay(subject, window, Operation::intersection), and its bytes, for any subject; `overlay` itself takes this way
  /// where it can see at small cost that it may. Cost: O(n + c log c), c edges near the window; that of `overlay` where
  /// the report says that it was handed over: something touches the window or nearly does, or edges meet near it.
  RegionSet clip(const RegionView& subject, ClassicReport* report = nullptr, const CallOptions& options = {}) const;

 private:
  struct Prepared;
  std::unique_ptr<const Prepared> prepared_;
};

}  // namespace oblast
