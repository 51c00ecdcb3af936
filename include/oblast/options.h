// What calls may be told, and what an overlay reports.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace oblast {

class Workspace;

enum class Operation { intersection, unite, difference, symmetric_difference };

/// Turns winding numbers into inside or outside.
struct FillRule {
  enum class Kind {
    polygons,  ///< each polygon is the even-odd of its own rings, the operand the union of its polygons
    at_least,  ///< as `polygons`, but: covered by at least `depth` polygons
    even_odd,  ///< winding number of all contours together is odd
    nonzero,   ///< ... is not zero
    positive,  ///< ... is greater than zero
    negative,  ///< ... is less than zero
  };
  Kind kind = Kind::polygons;
  std::int32_t depth = 1;  ///< for `at_least` only: 1 or more

  /// `polygons` and `at_least` read polygons one by one; the others all contours together, as directed.
  constexpr bool by_polygon() const { return kind == Kind::polygons || kind == Kind::at_least; }

  static constexpr FillRule polygons() { return {}; }
  static constexpr FillRule at_least(std::int32_t depth) { return {Kind::at_least, depth}; }
  static constexpr FillRule even_odd() { return {Kind::even_odd, 1}; }
  static constexpr FillRule nonzero() { return {Kind::nonzero, 1}; }
  static constexpr FillRule positive() { return {Kind::positive, 1}; }
  static constexpr FillRule negative() { return {Kind::negative, 1}; }

  friend bool operator==(const FillRule&, const FillRule&) = default;
};

/// The algorithm that labels the noded edges. All give the same bytes.
enum class Engine {
  leonov_nikitin,  ///< labels carried around vertices and along chains (preprint 46, 1997); the default
  vatti,           ///< the scan line of the 2013 paper
  skvortsov,       ///< constrained Delaunay triangulation, eaten inwards (2002)
};

/// How a contour that touches itself at a point is written.
enum class ContourConvention {
  ogc,             ///< every ring simple: a pinched hole is a shell and a hole; valid in every GIS
  leonov_nikitin,  ///< the walk hugs one sector of the interior: the pinched hole is one contour
};

/// Which collinear vertices a result keeps.
enum class CollinearVertices {
  keep,  ///< input vertices on the result's boundary stay (promise G3a)
  drop,  ///< the minimal result: vertices exactly on the line between their neighbours are left out
};

/// The numbered stages of the pipeline (ARCHITECTURE.md), for progress and for times.
enum class Stage { collect, node, label, select, link, assemble };
inline constexpr int stage_count = 6;

/// What a call did. Filled when Options::statistics points to one.
struct Statistics {
  std::uint64_t input_contours = 0;
  std::uint64_t input_vertices = 0;
  std::uint64_t output_polygons = 0;
  std::uint64_t output_contours = 0;
  std::uint64_t output_vertices = 0;
  std::uint64_t resolved_polygons = 0;  ///< polygons whose own rings meet, resolved by themselves first
  std::uint64_t intersections = 0;      ///< points at which noding cut an edge, each counted once
  std::uint64_t rounds = 0;             ///< rounding rounds, the last one (which finds nothing) included
  double largest_displacement = 0;      ///< largest distance of a cut point from its input edge, coordinate units
  /// The same in units in the last place of the largest coordinate, or of 2^-300 where these are smaller (domain.h).
  double largest_displacement_ulps = 0;
  double seconds[stage_count] = {};  ///< wall time by stage
};

/// Asked between pieces of work with the stage that is under way and the fraction of the whole call that is done: it
/// grows from one question to the next, and is 1 at the last one only, when all is done. It is an estimate. Asked at
/// most every 5 milliseconds, and on large inputs at least every 0.1 s or so.
///
/// Called from any thread that works for the call, never from two at a time. Returning false cancels the call: it
/// throws Error(cancelled) within about as long. What it throws ends the call likewise, and comes out as it is. After
/// either it is not asked again. It may make other calls of the library, but must not wait for its own call. It runs in
/// the caller's own floating-point environment. Functions without stages ask with the one that is most like theirs.
using Progress = std::function<bool(Stage stage, double fraction)>;

/// What every call may be told, whatever it computes. None of it makes a difference to the result.
struct CallOptions {
  static constexpr int most_threads = 1024;

  int threads = 0;    ///< 1 to most_threads; 0: all cores
  Progress progress;  ///< empty: nobody is asked
  /// Memory that calls leave for the next ones (workspace.h), for those who make many; null: they leave none.
  Workspace* workspace = nullptr;
  /// The bytes that the call's arrays and its result may take at any moment, else it ends with Error(memory_limit);
  /// 0: any. What the caller has, what a workspace keeps, stacks and a few small things are not counted.
  std::size_t most_bytes = 0;
};

/// What an overlay may be told. Where statistics or progress are asked for, or a rule, the engine or the collinear
/// vertices are not the default, every call goes through the stages that they tell of; otherwise `overlay` may take a
/// fast path with the same bytes (docs/methods.md), whatever `contours` and the other options of the call are.
struct Options : CallOptions {
  FillRule fill_a;  ///< rule of the first (or only) operand
  FillRule fill_b;  ///< rule of the second operand
  Engine engine = Engine::leonov_nikitin;
  ContourConvention contours = ContourConvention::ogc;
  CollinearVertices collinear = CollinearVertices::keep;
  Statistics* statistics = nullptr;  ///< filled when the call succeeds
};

}  // namespace oblast
