// A box parted into cells, and the edges by cell: how a grid is built, at first and where a cell is divided.
#pragma once

#include <oblast/point.h>

#include <cstddef>
#include <span>
#include <vector>

#include "base/call.h"
#include "locate/cell_grid.h"
#include "locate/edges.h"
#include "locate/lines.h"
#include "plane/box.h"

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

/// False as soon as there are more than `most` entries. `steps` may be null.
bool list_by_cell(const Edges& edges, std::span<const Index> list, const PartedBox& parted, std::size_t most,
                  CellLists& lists, Steps* steps);

}  // namespace oblast::internal::locate
