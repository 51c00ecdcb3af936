// A grid of cells, each with the edges that come by: how most points are located, by a look at a few edges. A cell
// where many come by is a grid of its own.
//
//      Y1 +-----------+
//         |        p  |    A cell knows whether its corner o is inside. From p a path goes straight down to q on the
//         |     | /|  |    lower line, and along it to o: p is inside as o is, turned once by each edge that crosses
//         the |     |/ |  |    path. All edges that do are in the cell's list, so nothing else is looked at. An empty
//         cell
//      Y0 o-----/--q--+    is known by its corner.
//         X0   /     X1
//
// No case is special: the path is taken to run right of x and below Y0 by infinitely little, the former the smaller of
// both (x + d, Y0 - e, d << e). So no vertex lies on it, and ties have one answer each:
//   an edge crosses the line x + d   when one end has x' <= x and the other has not
//   an edge crosses the line Y0 - e  when one end has y' < Y0 and the other has not
//   it passes below q                when q is left of it, run from left to right; not on it, since d << e
//   it passes left of q              when q is right of it, run upwards; on it, when it leans right or stands straight
//
// How often an edge crosses the path needs one orientation, of p, for the rest is the same for all p of the cell:
//
//   it crosses the line Y0 right of o   p left of it: not.  p beyond it: once, below q.  Under or over it: once if p is
//      (`crosses_line`)                 above a falling edge or below a rising one, be q left or right of where it
//      crosses
//   else                                p left of it or beyond it: not.  Under or over it: if p is above it and q is
//   not,
//                                       and which of both q is, holds for the whole cell
//
// So an edge is stored with its ends in one order or the other: it turns points that it passes over or under where they
// are left of it, from `a` to `b`.
#pragma once

#include <oblast/point.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "locate/edges.h"
#include "locate/lines.h"
#include "plane/box.h"

namespace oblast::internal::locate {

/// What a cell tells of a point. `crowded`: nothing, for there are too many edges.
enum class CellAnswer : std::uint8_t { outside, boundary, inside, crowded };

struct CellEdge {
  Point a, b;
};

struct Cell {
  enum class Kind : std::uint8_t { listed, divided, crowded };

  std::uint32_t begin = 0;      ///< listed: of its edges; divided: its grid
  std::uint8_t count = 0;       ///< listed: its edges
  std::uint8_t cross_line = 0;  ///< listed: the first so many cross the line right of its corner
  bool corner_inside = false;
  Kind kind = Kind::listed;
};

struct Grid {
  Lines columns, rows;
  std::uint32_t first_cell = 0;  ///< of the lowest row; then row by row

  std::uint32_t cell_of(const Point& p) const {
    return first_cell + rows.at(p.y) * (columns.last + 1) + columns.at(p.x);
  }
};

class CellGrid {
 public:
  /// Cost: O(n), and so is the memory.
  explicit CellGrid(const Edges& edges);

  bool has_crowds() const { return has_crowds_; }
  CellAnswer locate(const Point& p) const;
  /// answers[i] is that of points[i]. What is needed of memory is fetched for a few points ahead.
  void locate(std::span<const Point> points, CellAnswer* answers) const;

 private:
  friend class GridBuilder;

  CellAnswer look(const Cell& cell, const Point& p) const;
  const Cell& leaf_below(const Cell& cell, const Point& p) const;
  void fetch_what_is_below(const Cell& cell) const;

  Box box_{};
  std::vector<Grid> grids_;  ///< the first one of all the box
  std::vector<Cell> cells_;
  std::vector<CellEdge> edges_;
  bool has_crowds_ = false;
};

}  // namespace oblast::internal::locate
