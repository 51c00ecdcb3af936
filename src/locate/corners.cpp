#include "locate/corners.h"

#include <algorithm>

#include "exact/orientation.h"

namespace oblast::internal::locate {
namespace {

using exact::orientation;

bool crosses_column(const Point& from, const Point& to, double x) { return (from.x <= x) != (to.x <= x); }

/// Whether an edge that crosses the line just right of q does so below q.
bool passes_below(const Point& from, const Point& to, const Point& q) {
  if (std::max(from.y, to.y) < q.y) return true;
  if (std::min(from.y, to.y) > q.y) return false;
  const int side = orientation(from, to, q);
  return side != 0 && (side > 0) == (from.x < to.x);
}

/// The first corner of a row's line, from `first` on, that the edge passes left of; the edge crosses the line.
std::size_t first_corner_right_of(const Edges& edges, Index edge, const PartedBox& parted, double y,
                                  std::size_t first) {
  const Point &from = edges.from(edge), &to = edges.to(edge);
  const PartedAxis& columns = parted.columns;
  const auto is_right = [&](std::size_t column) { return passes_left(from, to, {columns.line(column), y}); };
  std::size_t column =
      std::max<std::size_t>(first, columns.lines().at(from.x + (to.x - from.x) * ((y - from.y) / (to.y - from.y))));
  while (column > first && is_right(column - 1)) --column;
  while (column < columns.count() && !is_right(column)) ++column;
  return column;
}

}  // namespace

bool passes_left(const Point& from, const Point& to, const Point& q) {
  if (std::max(from.x, to.x) <= q.x) return true;
  if (std::min(from.x, to.x) > q.x) return false;
  const int side = orientation(from, to, q);
  if (side == 0) return from.y < to.y ? from.x <= to.x : to.x <= from.x;
  return (side < 0) == (from.y < to.y);
}

void turn_corners(const Edges& edges, Index edge, const PartedBox& parted, std::size_t first, Cell* cells) {
  const double low = edges.lower(edge).y, high = edges.upper(edge).y;
  const std::size_t columns = parted.columns.count();
  for (std::size_t row = parted.rows.first_by(low), last = parted.rows.last_by(high); row <= last; ++row) {
    const double y = parted.rows.line(row);
    if (!(low < y && y <= high)) continue;
    if (first > 0 && passes_left(edges.from(edge), edges.to(edge), {parted.columns.line(0), y})) continue;
    const std::size_t column = first_corner_right_of(edges, edge, parted, y, first);
    if (column < columns) cells[row * columns + column].corner_inside ^= true;
  }
}

void turn_first_column(const Edges& edges, Index edge, const PartedBox& parted, Cell* cells) {
  const Point &from = edges.from(edge), &to = edges.to(edge);
  const double x = parted.columns.line(0);
  if (!crosses_column(from, to, x) || passes_below(from, to, {x, parted.rows.line(0)})) return;
  const std::size_t columns = parted.columns.count();
  const auto is_above = [&](std::size_t row) { return passes_below(from, to, {x, parted.rows.line(row)}); };
  std::size_t row =
      std::max<std::size_t>(1, parted.rows.lines().at(from.y + (to.y - from.y) * ((x - from.x) / (to.x - from.x))));
  while (row > 1 && is_above(row - 1)) --row;
  while (row < parted.rows.count() && !is_above(row)) ++row;
  if (row < parted.rows.count()) cells[row * columns].corner_inside ^= true;
}

void sum_rows(std::size_t columns, std::size_t rows, Cell* cells) {
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t c = row * columns + 1; c < (row + 1) * columns; ++c)
      cells[c].corner_inside ^= cells[c - 1].corner_inside;
}

}  // namespace oblast::internal::locate
