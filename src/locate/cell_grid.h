// A grid of cells, each with the edges that come by: how most points are located, by a look at a few edges.
//
//      Y1 +-----------+         A cell has its columns' and rows' lower lines: X0 <= x < X1, Y0 <= y < Y1. It knows
//         |     |  p  |         whether its corner o is inside. From p a path goes straight down to q on the lower
//         line, |     | /|  |         and along it to o: p is inside as o is, turned once by each edge that crosses the
//         path. |     |/ |  |         All edges that do are in the cell's list, so nothing else is looked at. An empty
//         cell is
//      Y0 o-----/--q--+         known by its corner.
//         X0   /     X1
//
// No case is special: the path is taken to run right of x and below Y0 by infinitely little, the former the smaller of
// both (x + d, Y0 - e, d << e). So no vertex lies on it, and ties have one answer each:
//   an edge crosses the line x + d   when one end has x' <= x and the other has not
//   an edge crosses the line Y0 - e  when one end has y' < Y0 and the other has not
//   it passes below q                when q is left of it, run from left to right; not on it, since d << e
//   it passes left of q              when q is right of it, run upwards; on it, when it leans right or stands straight
#pragma once

#include <oblast/point.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/tuning.h"
#include "locate/edges.h"
#include "plane/box.h"

namespace oblast::internal::locate {

/// What a cell tells of a point. `crowded`: nothing, for there are too many edges.
enum class CellAnswer : std::uint8_t { outside, boundary, inside, crowded };

class CellGrid {
 public:
  static constexpr std::size_t most_bytes_an_edge =
      sizeof(std::uint32_t) * (tuning::located_cells_an_edge + tuning::located_entries_an_edge);

  /// REQUIRES: the edges outlive it. Cost: O(n), and so is the memory.
  explicit CellGrid(const Edges& edges);

  bool has_crowds() const { return has_crowds_; }
  CellAnswer locate(const Point& p) const;

 private:
  /// Lines that part the columns, or the rows. They increase.
  struct Lines {
    Lines() = default;
    Lines(double from, double extent, std::size_t lines)
        : first(from), step(extent / static_cast<double>(lines)), lines_a_unit(step > 0 ? 1 / step : 0), count(lines) {}

    double operator[](std::size_t line) const { return first + static_cast<double>(line) * step; }
    /// The last line at or before a value that is not before the first one.
    std::size_t at(double value) const;

    double first = 0, step = 0, lines_a_unit = 0;
    std::size_t count = 0;
  };

  void choose_size(std::size_t cells);
  bool count_entries(std::size_t most);
  void list_edges();
  void find_corners();
  /// Calls visit(row, first column, past the last column) with all cells that the edge comes by, and maybe others.
  template <class Visit>
  void for_each_row(Index edge, const Visit& visit) const;
  std::size_t first_corner_right_of(Index edge, double y) const;

  const Edges& edges_;
  Box box_{};
  double margin_ = 0;
  Lines columns_, rows_;
  std::vector<std::uint32_t> cells_;  ///< by cell: twice where its list begins, and whether its corner is inside
  std::vector<Index> lists_;
  bool has_crowds_ = false;
};

}  // namespace oblast::internal::locate
