// The objects of proximity zones as plain segments and areas.
#pragma once

#include <oblast/buffer.h>
#include <oblast/features.h>

#include <cstdint>
#include <vector>

#include "verify/area.h"

namespace oblast::verify {

/// The boundary of the even-odd region of the rings: pieces that an even number of edges cover are left out. Edges are
/// cut only at vertices of the rings.
std::vector<Stroke> boundary_of(const RegionView& polygon);

/// Areas with numbers, and a tree to find those around a place. Each area is a polygon by even-odd.
struct NumberedAreas {
  std::vector<Area> areas;
  std::vector<std::uint32_t> numbers;
  BoxTree tree;

  void add(std::vector<Stroke> edges, std::uint32_t number);
  void build();

  /// The numbers of areas that hold p in their closure, ascending.
  std::vector<std::uint32_t> closed_at(const Point& p) const;
  /// The numbers on both sides of a place (Area::beside), ascending.
  struct Sides {
    std::vector<std::uint32_t> first, second;
  };
  Sides beside(const Location& p, bool on_horizontal) const;
};

/// Objects as rows of shapes. The region of an object is the union of its polygons, each the even-odd of its rings. A
/// polygon without area is nothing.
struct ZoneObjects {
  struct Edge : Stroke {
    std::uint32_t object;
    bool of_region;
  };
  std::vector<Edge> edges;  ///< of boundaries, lines and points
  NumberedAreas regions;    ///< a number is an object
  BoxTree tree;             ///< of the edges

  explicit ZoneObjects(const ShapeFeatures& objects);
};

}  // namespace oblast::verify
