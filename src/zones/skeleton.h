// Step 2 of zones: which edges and points have places near them to give away, and whose they are.
//
// Within polygons all places are taken. So only edges matter that have a side which no polygon covers: the outline of
// the union of all polygons, and lines outside of it. Where two polygons overlap by some units in the last place only,
// noding may open a gap between them, so their edges there matter, too. Each belongs to one object, the lowest that has
// it. A constrained triangulation of all edges finds the sides that are covered, and how near the next thing is to each
// contact.
//
// A contact is a vertex where edges of different objects meet. No site stands there. Instead, one stands on each of its
// edges at the same distance, the radius of the contact. Between two of them the border is the bisector of the edges,
// and starts at the vertex:
//
//        |
//        o   /          o: sites at the radius around the contact x. Every circle through three of them is centred at
//        | /            x; so x is put in the place of all of these centres.
//     ---x---o---
#pragma once

#include <cstdint>
#include <span>

#include "zones/settled_edges.h"

namespace oblast::internal::zoning {

struct Contact {
  Point at;
  double radius;  ///< a power of two, at most Room::sampling, and at most a quarter of the distance to what does not
                  ///< meet here, but not below some units in the last place
};

/// An edge with a side that is not covered, or at which noding may open a gap.
struct FreeEdge {
  Point low, high;
  std::uint32_t object;
  std::uint32_t low_contact, high_contact;  ///< none where its end is no contact
  std::uint32_t low_vertex, high_vertex;    ///< numbers of its ends: equal ends have one number
};

/// Strips along free edges, on the sides that are not covered: in the triangle on that side, in the third of it that
/// has this edge, and a sixteenth of epsilon wide at most. Where a triangle is too thin for that, the strip takes all
/// of it and goes on behind it.
///
///     low ------------- high
///        \ _________ /           the top: from high to low on the left of the edge, from low to high on its right
struct Strips {
  Array<Point> tops;
  Array<std::size_t> ends;  ///< two for each edge: of its right and left top

  std::span<const Point> right(std::size_t edge) const { return top(2 * edge); }
  std::span<const Point> left(std::size_t edge) const { return top(2 * edge + 1); }

 private:
  std::span<const Point> top(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends[i - 1];
    return std::span(tops).subspan(begin, ends[i] - begin);
  }
};

struct Skeleton {
  LargeArray<FreeEdge> edges;
  Strips strips;
  Array<std::uint32_t> object_of_vertex;  ///< the lowest that has an edge there
  Array<Contact> contacts;
  Array<LonePoint> points;  ///< those that no polygon covers and no edge ends at
};

Skeleton find_skeleton(const SettledObjects& settled, const Room& room);

}  // namespace oblast::internal::zoning
