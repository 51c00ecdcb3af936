// The options of calls, and the statistics of an overlay.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace oblast {

class Workspace;

enum class Operation { intersection, unite, difference, symmetric_difference };

/// Decides by winding numbers which points are inside an operand.
struct FillRule {
  enum class Kind {
    polygons,  ///< each polygon is filled by even-odd of its own rings; the operand is the union of its polygons
    at_least,  ///< as `polygons`, but inside is what at least `depth` polygons cover
    even_odd,  ///< the winding number of all contours together is odd
    nonzero,   ///< the winding number of all contours together is not zero
    positive,  ///< the winding number of all contours together is greater than zero
    negative,  ///< the winding number of all contours together is less than zero
  };
  Kind kind = Kind::polygons;
  std::int32_t depth = 1;  ///< for `at_least` only: 1 or more

  /// True for the rules that use polygons one by one. The others use all contours together, as they are directed.
  constexpr bool by_polygon() const { return kind == Kind::polygons || kind == Kind::at_least; }

  static constexpr FillRule polygons() { return {}; }
  static constexpr FillRule at_least(std::int32_t depth) { return {Kind::at_least, depth}; }
  static constexpr FillRule even_odd() { return {Kind::even_odd, 1}; }
  static constexpr FillRule nonzero() { return {Kind::nonzero, 1}; }
  static constexpr FillRule positive() { return {Kind::positive, 1}; }
  static constexpr FillRule negative() { return {Kind::negative, 1}; }

  friend bool operator==(const FillRule&, const FillRule&) = default;
};

/// The algorithm that labels the noded edges. All engines give the same bytes.
enum class Engine {
  leonov_nikitin,  ///< carries labels around vertices and along chains (preprint 46, 1997); the default
  vatti,           ///< the scan line of the 2013 paper
  skvortsov,       ///< a constrained Delaunay triangulation, classified from outside inwards (2002)
};

/// How a result represents a contour that touches itself at a point.
enum class ContourConvention {
  ogc,             ///< every ring is simple; a hole that is pinched off becomes a shell and a hole; valid in every GIS
  leonov_nikitin,  ///< a contour follows one sector of the interior at each vertex; the pinched hole is one contour
};

/// Which collinear vertices a result keeps.
enum class CollinearVertices {
  keep,  ///< input vertices on the boundary of the result stay (promise G3a)
  drop,  ///< vertices exactly on the line between their neighbours are left out: the minimal result
};

/// The numbered stages of the pipeline (ARCHITECTURE.md), for progress and for times.
enum class Stage { collect, node, label, select, link, assemble };
inline constexpr int stage_count = 6;

/// What an overlay did. A call that succeeds fills it if Options::statistics points to one.
struct Statistics {
  std::uint64_t input_contours = 0;
  std::uint64_t input_vertices = 0;
  std::uint64_t output_polygons = 0;
  std::uint64_t output_contours = 0;
  std::uint64_t output_vertices = 0;
  std::uint64_t resolved_polygons = 0;  ///< polygons whose own rings meet; they are resolved first
  std::uint64_t intersections = 0;      ///< points at which noding cut an edge, each counted once
  std::uint64_t rounds = 0;             ///< rounding rounds, including the last one, which finds nothing
  double largest_displacement = 0;      ///< largest distance of a cut point from its input edge, coordinate units
  /// The same in units in the last place of the largest coordinate, or in units of 2^-300 if those are smaller
  /// (domain.h).
  double largest_displacement_ulps = 0;
  double seconds[stage_count] = {};  ///< wall time by stage
};

/// The library calls this function while it works. `stage` is the current stage. `fraction` is the estimated share of
/// the whole call that is done: it grows with every call of the function, and is 1 only in the last one, when all is
/// done. The function is called at most every 5 milliseconds, and for large inputs about every 0.1 s or more often.
///
/// Any thread that works for the call may call it, but never two threads at once. If it returns false, the call throws
/// Error(cancelled) within about 0.1 s. If it throws, the call throws the same exception. In both cases the function is
/// not called again. It may call the library, but must not wait for the call that it reports on. It runs in the
/// floating-point environment of the caller. Functions that have no stages report Stage::collect. `triangulate` reports
/// the stages of the union, then Stage::assemble.
using Progress = std::function<bool(Stage stage, double fraction)>;

/// The options of every call. None of them changes the result.
struct CallOptions {
  static constexpr int most_threads = 1024;

  /// 1 to most_threads; 0: all cores. More than the process has cores are used only if the caller allows oneTBB to
  /// start them (`tbb::global_control`, max_allowed_parallelism).
  int threads = 0;
  Progress progress;  ///< empty: no progress is reported
  /// Memory that calls keep for later calls (workspace.h). Useful for a caller who makes many calls. Null: none is
  /// kept.
  Workspace* workspace = nullptr;
  /// The most bytes that the arrays of the call and its result may take at any moment. A call that needs more throws
  /// Error(memory_limit). 0: no limit. The caller's own arrays, memory that a workspace keeps, stacks and a few small
  /// objects do not count.
  std::size_t most_bytes = 0;
};

/// The options of an overlay. If a fill rule, `engine` or `collinear` is not the default, or if `statistics` or
/// `progress` is set, the call runs all stages of the pipeline. Otherwise `overlay` may take a fast path
/// (docs/methods.md), which gives the same bytes.
struct Options : CallOptions {
  FillRule fill_a;  ///< fill rule of the first (or only) operand
  FillRule fill_b;  ///< fill rule of the second operand
  Engine engine = Engine::leonov_nikitin;
  ContourConvention contours = ContourConvention::ogc;
  CollinearVertices collinear = CollinearVertices::keep;
  Statistics* statistics = nullptr;  ///< filled when the call succeeds
};

}  // namespace oblast
