#include "locate/cell_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/fetch.h"
#include "base/tuning.h"
#include "exact/filtered_orientation.h"
#include "exact/orientation.h"
#include "locate/grid_builder.h"

namespace oblast::internal::locate {

CellGrid::CellGrid(const Edges& edges) {
  if (!edges.edges.empty()) GridBuilder(edges, *this).build();
}

const Cell& CellGrid::leaf_below(const Cell& cell, const Point& p) const {
  const Cell* leaf = &cell;
  while (leaf->kind == Cell::Kind::divided) leaf = &cells_[grids_[leaf->begin].cell_of(p)];
  return *leaf;
}

/// REQUIRES: the cell is not divided. Without branches where the filter of `orientation` decides: the outcomes are hard
/// to foresee.
CellAnswer CellGrid::look(const Cell& cell, const Point& p) const {
  if (cell.kind == Cell::Kind::crowded) return CellAnswer::crowded;
  unsigned inside = cell.corner_inside;
  const CellEdge* const edges = edges_.data() + cell.begin;
  for (unsigned i = 0; i < cell.count; ++i) {
    const Point &a = edges[i].a, &b = edges[i].b;
    const double x0 = std::min(a.x, b.x), x1 = std::max(a.x, b.x);
    const exact::FilteredOrientation side(a, b, p);
    unsigned is_left = side.is_left();
    const unsigned from = x0 <= p.x, past = x1 <= p.x;
    if (static_cast<unsigned>(!side.is_certain()) & from & static_cast<unsigned>(p.x <= x1)) [[unlikely]] {
      const int exactly = exact::orientation(a, b, p);
      if (exactly == 0 && std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y)) return CellAnswer::boundary;
      is_left = exactly > 0;
    }
    inside ^= (from & ~past & is_left) | (past & static_cast<unsigned>(i < cell.cross_line));
  }
  return inside != 0 ? CellAnswer::inside : CellAnswer::outside;
}

CellAnswer CellGrid::locate(const Point& p) const {
  if (!box_.contains(p) || grids_.empty()) return CellAnswer::outside;
  return look(leaf_below(cells_[grids_[0].cell_of(p)], p), p);
}

void CellGrid::fetch_what_is_below(const Cell& cell) const {
  const bool divided = cell.kind == Cell::Kind::divided;
  const auto* const grid = reinterpret_cast<const char*>(grids_.data() + cell.begin);
  const auto* const edges = reinterpret_cast<const char*>(edges_.data() + cell.begin);
  const char* const first = divided ? grid : edges;
  fetch(first);
  fetch(first + sizeof(CellEdge) + sizeof(Point));
}

void CellGrid::locate(std::span<const Point> points, CellAnswer* answers) const {
  if (grids_.empty()) {
    std::fill_n(answers, points.size(), CellAnswer::outside);
    return;
  }
  constexpr std::size_t block = tuning::queries_a_block;
  std::array<const Cell*, block> cells;
  const Grid whole = grids_[0];
  while (!points.empty()) {
    const std::size_t count = std::min(block, points.size());
    // A point outside of the box takes any cell, and is told apart at the end.
    for (std::size_t i = 0; i < count; ++i) {
      const Cell* const cell = cells_.data() + whole.cell_of(points[i]);
      cells[i] = cell;
      fetch(cell);
    }
    for (std::size_t i = 0; i < count; ++i) fetch_what_is_below(*cells[i]);
    for (std::size_t i = 0; i < count; ++i) {
      if (cells[i]->kind != Cell::Kind::divided) continue;
      cells[i] = &cells_[grids_[cells[i]->begin].cell_of(points[i])];
      fetch(cells[i]);
    }
    for (std::size_t i = 0; i < count; ++i) fetch_what_is_below(*cells[i]);
    for (std::size_t i = 0; i < count; ++i)
      answers[i] = box_.contains(points[i]) ? look(leaf_below(*cells[i], points[i]), points[i]) : CellAnswer::outside;
    points = points.subspan(count);
    answers += count;
  }
}

}  // namespace oblast::internal::locate
