// Which corners of cells are inside: each edge turns those right of it, or above. Ties as in cell_grid.h.
#pragma once

#include <oblast/point.h>

#include <cstddef>

#include "locate/cell_grid.h"
#include "locate/edges.h"
#include "locate/parted_box.h"

namespace oblast::internal::locate {

inline bool crosses_line(const Point& from, const Point& to, double y) { return (from.y < y) != (to.y < y); }

/// Whether an edge that crosses the line just below q does so left of what is just right of q.
bool passes_left(const Point& from, const Point& to, const Point& q);

/// Turns the corners of each row from the first one on that the edge passes left of, where that is at `first` or after:
/// as differences, from one corner to the next.
void turn_corners(const Edges& edges, Index edge, const PartedBox& parted, std::size_t first, Cell* cells);

/// The same up the first column, from the second corner on.
void turn_first_column(const Edges& edges, Index edge, const PartedBox& parted, Cell* cells);

/// From differences along each row to what the corners are.
void sum_rows(std::size_t columns, std::size_t rows, Cell* cells);

}  // namespace oblast::internal::locate
