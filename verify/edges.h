// The edges of a result, with their contours and polygons. The checks of G2 use them.
#pragma once

#include <oblast/region_set.h>

#include <cstdint>
#include <string>
#include <vector>

#include "verify/verify.h"

namespace oblast::verify {

/// The edges of all contours. Edge i runs from vertex i (an index into points) to vertex next[i].
struct Edges {
  RegionView regions;
  std::vector<std::uint32_t> next;
  std::vector<std::uint32_t> contour_of;  ///< of edge i, and so of vertex i
  std::vector<std::uint32_t> polygon_of;  ///< of a contour

  explicit Edges(const RegionView& view);

  std::size_t size() const { return next.size(); }
  const Point& from(std::uint32_t e) const { return regions.points[e]; }
  const Point& to(std::uint32_t e) const { return regions.points[next[e]]; }

  /// True if edge e runs in lexicographic order.
  bool forward(std::uint32_t e) const { return lexicographically_less(from(e), to(e)); }
  const Point& left_end(std::uint32_t e) const { return forward(e) ? from(e) : to(e); }
  const Point& right_end(std::uint32_t e) const { return forward(e) ? to(e) : from(e); }

  std::uint32_t polygon_of_edge(std::uint32_t e) const { return polygon_of[contour_of[e]]; }

  Place place_of(std::uint32_t vertex) const;
  Fault fault_at(std::uint32_t vertex, const std::string& what) const;
};

/// A text such as "(1, 2.5)", with enough digits to read back the same bits.
std::string to_text(const Point& p);

}  // namespace oblast::verify
