#include "check/report.h"

#include <algorithm>
#include <charconv>

namespace oblast::internal::checking {
namespace {

Place place_of(const RegionView& regions, std::uint32_t vertex) {
  Place place;
  if (vertex == none) return place;
  const auto index_of = [](std::span<const std::uint32_t> ends, std::size_t i) {
    return static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), i) - ends.begin());
  };
  place.contour = index_of(regions.contour_ends, regions.first_point + vertex);
  place.polygon = regions.polygon_ends.empty() ? place.contour
                                               : index_of(regions.polygon_ends, regions.first_contour + place.contour);
  place.vertex = vertex - regions.contour_begin(place.contour);
  return place;
}

std::string number(double x) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, x).ptr};
}

std::string text(const Point& p) { return "(" + number(p.x) + " " + number(p.y) + ")"; }

/// The edge that begins at a vertex.
std::string edge(const RegionView& regions, std::uint32_t vertex) {
  const Place place = place_of(regions, vertex);
  const auto contour = regions.contour(place.contour);
  return text(contour[place.vertex]) + " -> " + text(contour[(place.vertex + 1) % contour.size()]);
}

std::string message(const RegionView& regions, const Finding& f) {
  const std::string at = text(f.point);
  const auto edges = [&](const char* what) {
    return "edge " + edge(regions, f.vertex) + " and edge " + edge(regions, f.other) + what + at;
  };
  const auto other_point = [&] { return text(regions.points[f.other]); };
  switch (f.kind) {
    case FaultKind::bad_offsets:
      break;
    case FaultKind::not_finite:
      return "a coordinate of the vertex " + at + " is not a finite number";
    case FaultKind::out_of_domain:
      return "the vertex " + at + " is outside the domain: a magnitude must be 0 or between 2^-300 and 2^300";
    case FaultKind::too_few_vertices:
      return "the contour at " + at + " has fewer than three vertices";
    case FaultKind::repeated_vertex:
      return "the vertex " + at + " is repeated by the next one of its contour";
    case FaultKind::edges_cross:
      return edges(" cross near ");
    case FaultKind::vertex_on_edge:
      return edges(" meet inside one of them, at ");
    case FaultKind::edges_overlap:
      return edges(" overlap from ");
    case FaultKind::touches_itself:
      return "the contour touches itself at " + at + " in a way that its convention does not admit";
    case FaultKind::wrong_side:
      return "the right side of edge " + edge(regions, f.vertex) +
             " is not outside: polygons overlap, or a contour runs in the wrong direction";
    case FaultKind::outer_is_not_first:
      return "the first contour of the polygon, from " + at + ", is a hole";
    case FaultKind::hole_is_outer:
      return "a later contour of the polygon, from " + at + ", is not a hole";
    case FaultKind::other_polygon:
      return "at " + at + " contours of two polygons bound one region: from " + text(regions.points[f.vertex]) +
             " and from " + other_point();
    case FaultKind::not_connected:
      return "the interior of the polygon is not connected: the part along edge " + edge(regions, f.vertex) +
             " is cut off from the one along edge " + edge(regions, f.other);
    case FaultKind::negative_zero:
      return "a coordinate of the vertex " + at + " is negative zero";
    case FaultKind::wrong_start:
      return "the contour starts at " + at + "; it should start at " + other_point();
    case FaultKind::holes_out_of_order:
      return "the hole from " + at + " should come before the hole from " + other_point();
    case FaultKind::polygons_out_of_order:
      return "the polygon from " + at + " should come before the polygon from " + other_point();
  }
  return {};
}

}  // namespace

Fault report_of(const RegionView& regions, const Finding& finding) {
  return {finding.kind, place_of(regions, finding.vertex), place_of(regions, finding.other), finding.point,
          message(regions, finding)};
}

}  // namespace oblast::internal::checking
