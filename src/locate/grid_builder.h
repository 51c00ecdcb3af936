// How a grid of cells is made: edges are listed by cell, the corners found inside or outside, long lists divided.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "locate/cell_grid.h"
#include "locate/edges.h"
#include "locate/parted_box.h"

namespace oblast::internal::locate {

class GridBuilder {
 public:
  /// REQUIRES: there are edges.
  GridBuilder(const Edges& edges, CellGrid& grid) : edges_(edges), grid_(grid) {}

  void build();

 private:
  /// Cells of one range of the whole grid, with what is below them; indices count from the range's own beginnings.
  struct Part {
    std::vector<Grid> grids;
    std::vector<Cell> cells;
    std::vector<CellEdge> edges;
    std::size_t entries_left = 0;  ///< of divided cells
    bool has_crowds = false;
  };
  struct Pending;

  void finish_cells(const PartedBox& parted, const CellLists& lists, std::size_t begin, std::size_t end, Part& part);
  void finish(Cell& cell, const Box& box, std::span<const Index> list, Part& part, std::vector<Pending>& pending,
              int divisions) const;
  bool divide(const Pending& what, Part& part, std::vector<Pending>& pending) const;
  void list_edges(Cell& cell, const Point& corner, std::span<const Index> list, Part& part) const;
  void join(std::vector<Part>& parts, std::size_t cells_a_part);

  const Edges& edges_;
  CellGrid& grid_;
  double margin_x_ = 0, margin_y_ = 0;
};

}  // namespace oblast::internal::locate
