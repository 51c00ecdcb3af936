// Step 1 of zones: the edges of all objects, cut where they meet.
//
// Polygons enter as in an overlay of rows. Lines enter as paths of one direction, with changes of operand B, so that
// copies of one edge never cancel each other.
#pragma once

#include <oblast/options.h>

#include <cstdint>

#include "base/control.h"
#include "base/large_pages.h"
#include "noding/strands.h"
#include "zones/objects.h"

namespace oblast::internal::zoning {

/// An edge from `low` to `high`, the lexicographically smaller end first, with all its copies.
struct SettledEdge {
  Point low, high;
  std::int32_t cover;        ///< how many polygons more cover its left side than its right one
  std::uint32_t outline_of;  ///< the lowest object whose polygons cover just one of its sides; none if there is none
  std::uint32_t line_of;     ///< the lowest object with a line along it; none if there is none
};

struct LonePoint {
  Point at;
  std::uint32_t object;  ///< the lowest one that is there
};

struct SettledObjects {
  noding::Strands polygons;  ///< the edges of polygons; they meet at ends only. Changes are handles of `changes`, in A
  LargeArray<SettledEdge> edges;  ///< no two are equal; in order, and the same for any order of the shapes
  Array<LonePoint> points;        ///< in order, no two at one place; also lines of no length
};

/// REQUIRES: `changes` is for at least 2 objects.count sources.
SettledObjects settle_objects(const Objects& objects, noding::SourceChanges& changes, Control& control,
                              Statistics& statistics);

}  // namespace oblast::internal::zoning
