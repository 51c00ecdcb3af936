// Whether regions are what an overlay gives: closed, valid and canonical (promises G2 and G3), or the first fault.
#pragma once

#include <oblast/error.h>
#include <oblast/export.h>
#include <oblast/options.h>
#include <oblast/point.h>
#include <oblast/region_set.h>

#include <optional>
#include <string>

namespace oblast {

/// What may be wrong. One group is looked for after the other, and only if those before found nothing.
enum class FaultKind {
  bad_offsets,  ///< an end steps back, or is not the end of its array; or a contour or polygon is empty

  not_finite,     ///< a coordinate is NaN or infinite
  out_of_domain,  ///< a coordinate's magnitude is outside the domain (domain.h)

  too_few_vertices,  ///< a contour has one or two vertices
  repeated_vertex,   ///< a vertex equals the next one of its contour; after the last one comes the first

  edges_cross,     ///< two edges cross inside both
  vertex_on_edge,  ///< an end of one edge lies inside another edge
  edges_overlap,   ///< two edges have more than a point in common

  touches_itself,  ///< a contour goes through a vertex twice; under `leonov_nikitin`: and does not hug one sector there

  wrong_side,  ///< polygons overlap, or a contour runs in the wrong direction

  outer_is_not_first,  ///< the first contour of a polygon is a hole
  hole_is_outer,       ///< a later contour of a polygon is not a hole

  other_polygon,  ///< contours of two polygons bound one region: a hole is not in its own polygon

  not_connected,  ///< the interior of a polygon is in two parts or more

  negative_zero,  ///< a coordinate is -0.0

  wrong_start,  ///< a contour does not start at its smallest vertex

  holes_out_of_order,     ///< a hole comes after one that is larger, as a sequence of vertices
  polygons_out_of_order,  ///< the same of polygons, by their outer contours
};

/// Is the order looked at, too: the kinds from `negative_zero` on?
enum class CheckedOrder {
  canonical,  ///< yes: promise G3
  any,        ///< no: regions of other programs have theirs
};

struct CheckOptions : CallOptions {
  ContourConvention contours = ContourConvention::ogc;  ///< whether contours may touch themselves
  CheckedOrder order = CheckedOrder::canonical;
};

/// Of all faults of the first group that has one, the one with the smallest indices.
struct Fault {
  FaultKind kind;
  Place place;          ///< polygon, contour and vertex; a vertex stands for the edge from it, where edges are at fault
  Place other;          ///< the second edge, vertex or contour that is concerned; `npos` if there is none
  Point point;          ///< where: of a crossing it is the nearest double; zero if kind is bad_offsets
  std::string message;  ///< one sentence, with coordinates
};

struct CheckReport {
  std::optional<Fault> fault;

  bool is_valid() const { return !fault; }
};

/// Proves, exactly: offsets, coordinates and contours are well-formed. Edges meet only at common end points. The
/// interior of each polygon is one connected region, on the left of all its contours. It overlaps no other one. The
/// first contour of a polygon is its outer one and runs counter-clockwise; the others are its holes and run clockwise.
/// No contour goes through a vertex twice, unless options.contours admits it. Contours start at their smallest
/// vertices, and holes and polygons are in order, unless options.order is `any`.
///
/// A fault is no error: the regions may be anything. It is the same fault on any number of threads.
/// Cost: O((n + k) log n) time, n edges, k pairs of edges that meet; O(n) memory.
/// Throws Error: too_large, bad_option, cancelled, memory_limit.
OBLAST_API CheckReport check(const RegionView& regions, const CheckOptions& options = {});

}  // namespace oblast
