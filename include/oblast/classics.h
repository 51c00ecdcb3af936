// The classic methods of Skvortsov 2002, section 2. Each has a domain of its own, and the same result as `overlay`.
//
// Each function first checks whether the operands are in its domain. If they are not, it throws Error(precondition).
// The message names the contour and the vertex at fault, and a method to use instead; the Place of the error has the
// same indices. Inside the domain, exact predicates decide every degenerate meeting (vertex on edge, vertex on vertex,
// shared edges), and the result is the same as that of `overlay`, byte for byte.
//
// n1, n2: vertices of A and B. n = n1 + n2. k: points at which the boundaries meet.
#pragma once

#include <oblast/error.h>
#include <oblast/export.h>
#include <oblast/options.h>
#include <oblast/region_set.h>

#include <cstdint>
#include <memory>

namespace oblast {

enum class ClassicMethod { orourke, sutherland_hodgman, weiler_atherton, margalit_knott };

/// What a classic method did. A function fills it if it gets a pointer to one.
struct ClassicReport {
  std::uint64_t steps = 0;     ///< advances (O'Rourke) or half-planes (Sutherland-Hodgman); 0 for the others
  std::uint64_t meetings = 0;  ///< points at which the boundaries of A and B meet
  /// True if the method passed its operands on to `overlay`. It does so if a meeting lies too close to another vertex
  /// or edge (within 2^-46 of the largest coordinate): rounding that meeting might change what meets what. `overlay`
  /// repeats rounding until nothing changes.
  bool handed_over = false;
};

/// O'Rourke, Chien, Olson and Naddor 1982 (Skvortsov, section 2.1): convex with convex.
/// Domain: each operand is one convex contour, in either direction. Vertices on a straight side are allowed. The
/// operation is intersection, union or difference.
/// Cost: at most 2(n1 + n2) advances in O(n1 + n2) time, and O(k log k) to sort the meetings.
/// Throws Error: precondition, and as `overlay`.
OBLAST_API RegionSet orourke(const RegionView& a, const RegionView& b, Operation operation,
                             ClassicReport* report = nullptr, const CallOptions& options = {});

/// Sutherland and Hodgman 1974 (Skvortsov, section 2.2): clips `subject` to a convex window. Intersection only.
/// Domain: the window is one convex contour with m sides. The subject is one polygon of any contours, filled by
/// even-odd, or several polygons that meet each other at vertices only. If the subject crosses itself, it is resolved
/// first, because a result must be closed.
/// Cost, with n vertices of the subject: O(m n log n) in the worst case; O(m n) if few edges cross the window; O(n log
/// n) to test that the subject is simple.
/// Throws Error: precondition, and as `overlay`.
OBLAST_API RegionSet sutherland_hodgman(const RegionView& subject, const RegionView& window,
                                        ClassicReport* report = nullptr, const CallOptions& options = {});

/// Weiler and Atherton 1977 (Skvortsov, section 2.3): regular polygons with oriented contours. Holes are allowed.
/// Domain: in each operand edges meet at their ends only, and the interior is on the same side of all contours: left of
/// all or right of all, as they are directed. The grouping of contours into polygons does not matter. The operation is
/// intersection, union or difference.
/// Cost: O((n + k) log n).
/// Throws Error: precondition, and as `overlay`.
OBLAST_API RegionSet weiler_atherton(const RegionView& a, const RegionView& b, Operation operation,
                                     ClassicReport* report = nullptr, const CallOptions& options = {});

/// Margalit and Knott 1989 (Skvortsov, section 2.4): vertex-complete polygons.
/// Domain: each operand is one contour, in either direction, filled by even-odd. Any two of its edges are disjoint,
/// meet at their ends only, or coincide. So keyholes and figures of eight are allowed. The operation is intersection,
/// union or difference.
/// Cost: O((n + k) log n). This is the improvement that Skvortsov's Table 1 calls theoretical.
/// Throws Error: precondition, and as `overlay`.
OBLAST_API RegionSet margalit_knott(const RegionView& a, const RegionView& b, Operation operation,
                                    ClassicReport* report = nullptr, const CallOptions& options = {});

/// Calls one of the functions above. Throws Error as that function; precondition if the method does not have the
/// operation.
OBLAST_API RegionSet classic(ClassicMethod method, const RegionView& a, const RegionView& b, Operation operation,
                             ClassicReport* report = nullptr, const CallOptions& options = {});

/// A convex window that is prepared once and then clips any number of polygons. Most parts of a subject are decided by
/// their bounding boxes, so the cost depends on what comes near the window. Several threads may use it at once.
class OBLAST_API ClipWindow {
 public:
  /// `window` is one convex contour. Errors as for the window of `sutherland_hodgman`. Copies the contour.
  explicit ClipWindow(const RegionView& window, const CallOptions& options = {});
  /// The rectangle with x0 < x1 and y0 < y1. Throws Error(precondition) for any other one, and not_finite or
  /// out_of_domain for its coordinates.
  ClipWindow(double x0, double y0, double x1, double y1);
  ~ClipWindow();
  ClipWindow(ClipWindow&&) noexcept;
  ClipWindow& operator=(ClipWindow&&) noexcept;

  /// The same as overlay(subject, window, Operation::intersection), byte for byte, for any subject. (`overlay` takes
  /// the same fast path if a cheap test shows that it can.)
  /// Cost: O(n + c log c), with c edges near the window. If the report says `handed_over`, the cost is that of
  /// `overlay`. This happens if something touches or nearly touches the window, if edges meet near it, or if it has
  /// more than 64 sides. Throws Error: as `overlay`.
  RegionSet clip(const RegionView& subject, ClassicReport* report = nullptr, const CallOptions& options = {}) const;

 private:
  struct Prepared;
  std::unique_ptr<const Prepared> prepared_;
};

}  // namespace oblast
