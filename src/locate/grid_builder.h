// How a grid of cells is made: edges are listed by cell, the corners found inside or outside, long lists divided.
#pragma once

#include <cstddef>
#include <vector>

#include "base/memory_budget.h"
#include "locate/cell_grid.h"
#include "locate/edges.h"
#include "locate/lines.h"

namespace oblast::internal::locate {

/// A grid's lines, while it is built.
struct PartedBox {
  PartedAxis columns, rows;

  /// Cells about as high as they are wide. REQUIRES: cells > 0.
  PartedBox(const Box& box, double margin_x, double margin_y, std::size_t cells);

  std::size_t cells() const { return columns.count() * rows.count(); }
  Grid grid(std::size_t first_cell) const;
  Point corner(std::size_t cell) const {
    return {columns.line(cell % columns.count()), rows.line(cell / columns.count())};
  }
  /// All points that are in the cell.
  Box box_of(std::size_t cell) const {
    const std::size_t column = cell % columns.count(), row = cell / columns.count();
    return {columns.line(column), rows.line(row), columns.end_of(column), rows.end_of(row)};
  }
};

/// The edges by cell: of cell c they are items[begins[c]] to items[begins[c + 1]].
struct CellLists {
  std::vector<Index> begins, items;

  std::size_t count(std::size_t cell) const { return begins[cell + 1] - begins[cell]; }
  std::span<const Index> of(std::size_t cell) const { return {items.data() + begins[cell], count(cell)}; }
};

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
