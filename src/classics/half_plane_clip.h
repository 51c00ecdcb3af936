// Exact clipping by half-planes, one after another: the steps of Sutherland and Hodgman.
//
// No point is constructed. A vertex is an input point, or the crossing of two lines that each run through two input
// points. Exact predicates compare both. So the order of the half-planes does not matter, nor does the number of times
// that a point is clipped.
#pragma once

#include <cstdint>
#include <span>

#include "base/call_memory.h"
#include "base/index.h"
#include "classics/crossing.h"
#include "classics/operand.h"

namespace oblast::internal::classics {

/// A convex window. Collinear sides are one side.
struct ConvexWindow {
  Array<Point> ring;             ///< the input, counter-clockwise, without repeated neighbours
  Array<Line> sides;             ///< from corner to corner; side i ends where side i + 1 begins
  Array<Array<Point>> straight;  ///< by side: vertices inside it, in its direction
  Point low, high;               ///< its box
  bool safe_magnitudes = true;   ///< coordinates are in the range of crossing.h

  explicit ConvexWindow(Ring convex);
};

/// Lines are numbered: first the subject's edges by their first point, then the window's sides.
struct ClipVertex {
  Point at;                    ///< the point, unless it is a crossing
  std::uint32_t along = none;  ///< line of the edge that begins here, in its direction
  std::uint32_t first = none;  ///< crossing: of which lines
  std::uint32_t second = none;

  bool is_crossing() const { return first != none; }
};

class HalfPlaneClip {
 public:
  /// REQUIRES: the rings together are regular, with the interior on the left; coordinates are in the range of
  /// crossing.h.
  HalfPlaneClip(std::span<const Ring> subject, const ConvexWindow& window);

  /// Clips by every side of the window. False if the subject is not regular. Cost: O(m n log n) for m sides and n
  /// vertices; O(m n) if few edges cross sides.
  bool run();

  /// window::Contours of the result, the interior on the left: vertices and where each contour ends.
  const Array<ClipVertex>& vertices() const { return vertices_; }
  const Array<std::uint32_t>& ends() const { return ends_; }
  /// By side: the vertices of the subject on that side of the window that are not ends of paths.
  const Array<Array<Point>>& touches() const { return touches_; }
  Line line(std::uint32_t id) const;
  std::uint32_t subject_edges() const { return static_cast<std::uint32_t>(edges_.size()); }

 private:
  struct Path {
    std::uint32_t begin, end;  ///< its vertices in path_vertices_; the first and the last one are on the line
  };
  struct PathEnd {
    ClipVertex vertex;
    Line ray;  ///< direction away from the line
    std::uint32_t path;
    bool entry;
  };

  bool clip(std::uint32_t side);
  void split(std::uint32_t begin, std::uint32_t end, std::uint32_t side);
  bool join(std::uint32_t side);
  int side_of(const ClipVertex& v, std::uint32_t side) const;
  ClipVertex cross(std::uint32_t edge, std::uint32_t side) const;
  std::uint32_t other_line(const ClipVertex& v, std::uint32_t side) const;
  int compare_along(const ClipVertex& v, const ClipVertex& w, std::uint32_t side) const;
  void add_path_end(std::uint32_t path, bool entry);

  const ConvexWindow& window_;
  Array<Line> edges_;
  Array<ClipVertex> vertices_;
  Array<std::uint32_t> ends_;
  Array<Array<Point>> touches_;
  // of one clip
  Array<int> sides_;
  Array<ClipVertex> path_vertices_, kept_;
  Array<std::uint32_t> kept_ends_;
  Array<Path> paths_;
  Array<PathEnd> path_ends_;
  Array<Point> on_line_;
};

}  // namespace oblast::internal::classics
