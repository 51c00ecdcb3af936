#include "locate/grid_builder.h"

#include <algorithm>

#include "base/call.h"
#include "base/index.h"
#include "base/large_pages.h"
#include "base/memory_budget.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "locate/corners.h"

namespace oblast::internal::locate {
namespace {

constexpr std::size_t most_entries = 0xffffffff;
static_assert(std::max(tuning::undivided_edges, tuning::looked_at_in_a_cell) <= 255, "Cell::count has a byte");

}  // namespace

/// A cell that will be divided.
struct GridBuilder::Pending {
  std::size_t cell;  ///< among the part's; the whole grid's cells of the range come first
  Box box;
  std::vector<Index> list;
  int divisions;
};

void GridBuilder::build() {
  const std::size_t count = edges_.edges.size();
  const Point& first = edges_.from(edges_.edges[0]);
  Box box = Box::of(first, first);
  for (const Index e : edges_.edges) box = box.joined(edges_.from(e));
  grid_.box_ = box;
  margin_x_ = PartedAxis::margin_of(box.x0, box.x1);
  margin_y_ = PartedAxis::margin_of(box.y0, box.y1);

  const std::size_t most =
      std::min(tuning::located_entries_an_edge * count + tuning::located_cells_besides, most_entries);
  std::size_t cells = tuning::located_cells_an_edge * count + tuning::located_cells_besides;
  PartedBox parted(box, margin_x_, margin_y_, cells);
  CellLists lists;
  const Charge charge(sizeof(Index) * (most + parted.cells()));
  Steps steps(2 * count);
  while (!list_by_cell(edges_, edges_.edges, parted, most, lists, &steps))
    parted = PartedBox(box, margin_x_, margin_y_, cells /= 4);  // one cell has no more entries than there are edges

  grid_.cells_.resize(parted.cells());
  grid_.grids_.push_back(parted.grid(0));
  for (const Index e : edges_.edges) turn_corners(edges_, e, parted, 0, grid_.cells_.data());
  sum_rows(parted.columns.count(), parted.rows.count(), grid_.cells_.data());

  const std::size_t size = tuning::finished_cells_a_task;
  std::vector<Part> parts(range_count(parted.cells(), size));
  for_numbered_ranges(parted.cells(), size, [&](std::size_t part, std::size_t begin, std::size_t end) {
    finish_cells(parted, lists, begin, end, parts[part]);
  });
  join(parts, size);
}

void GridBuilder::finish_cells(const PartedBox& parted, const CellLists& lists, std::size_t begin, std::size_t end,
                               Part& part) {
  const std::size_t entries = lists.begins[end] - lists.begins[begin];
  part.cells.assign(grid_.cells_.begin() + static_cast<std::ptrdiff_t>(begin),
                    grid_.cells_.begin() + static_cast<std::ptrdiff_t>(end));
  part.edges.reserve(entries);
  part.entries_left = tuning::located_entries_an_edge * entries;
  std::vector<Pending> pending;
  for (std::size_t c = begin; c < end; ++c) {
    const std::span<const Index> list = lists.of(c);
    if (list.empty()) continue;
    if (list.size() > tuning::undivided_edges)
      pending.push_back({c - begin, parted.box_of(c), {list.begin(), list.end()}, tuning::located_divisions});
    else
      list_edges(part.cells[c - begin], parted.corner(c), list, part);
    while (!pending.empty()) {
      const Pending next = std::move(pending.back());
      pending.pop_back();
      poll();
      if (divide(next, part, pending)) continue;
      Cell& cell = part.cells[next.cell];
      if (next.list.size() <= tuning::looked_at_in_a_cell) {
        list_edges(cell, {next.box.x0, next.box.y0}, next.list, part);
      } else {
        cell.kind = Cell::Kind::crowded;
        part.has_crowds = true;
      }
    }
  }
}

/// False where nothing would be gained, or the part has had its memory.
bool GridBuilder::divide(const Pending& what, Part& part, std::vector<Pending>& pending) const {
  const std::size_t count = what.list.size();
  if (what.divisions == 0) return false;
  const PartedBox parted(what.box, margin_x_, margin_y_, tuning::divided_cells_an_edge * count);
  CellLists lists;
  const std::size_t cells = parted.cells();
  if (cells < 2 || cells > part.entries_left) return false;
  if (!list_by_cell(edges_, what.list, parted,
                    std::min(tuning::located_entries_an_edge * count, part.entries_left - cells), lists, nullptr))
    return false;
  part.entries_left -= cells + lists.items.size();

  const std::size_t first = part.cells.size();
  part.cells.resize(first + cells);
  Cell& whole = part.cells[what.cell];
  whole.kind = Cell::Kind::divided;
  whole.begin = static_cast<std::uint32_t>(part.grids.size());
  part.grids.push_back(parted.grid(first));
  Cell* const its = part.cells.data() + first;
  for (const Index e : what.list) {
    turn_corners(edges_, e, parted, 1, its);
    turn_first_column(edges_, e, parted, its);
  }
  const std::size_t columns = parted.columns.count();
  its[0].corner_inside = whole.corner_inside;
  for (std::size_t row = 1; row < parted.rows.count(); ++row)
    its[row * columns].corner_inside ^= its[(row - 1) * columns].corner_inside;
  sum_rows(columns, parted.rows.count(), its);

  for (std::size_t c = 0; c < cells; ++c) {
    const std::span<const Index> list = lists.of(c);
    if (list.size() > tuning::undivided_edges)
      pending.push_back({first + c, parted.box_of(c), {list.begin(), list.end()}, what.divisions - 1});
    else if (!list.empty())
      list_edges(part.cells[first + c], parted.corner(c), list, part);
  }
  return true;
}

/// Those first that cross the line right of the corner. See cell_grid.h for which end is `a`.
void GridBuilder::list_edges(Cell& cell, const Point& corner, std::span<const Index> list, Part& part) const {
  const std::size_t begin = part.edges.size();
  std::size_t cross_line = 0;
  for (const Index e : list) {
    const bool rightward = edges_.from(e).x <= edges_.to(e).x;
    const Point &left = rightward ? edges_.from(e) : edges_.to(e), &right = rightward ? edges_.to(e) : edges_.from(e);
    const bool crosses = crosses_line(left, right, corner.y),
               crosses_right = crosses && !passes_left(left, right, corner);
    const bool rising = left.y < right.y;
    // Whether it turns the points under it, not those over it.
    const bool turns_below = crosses ? rising == crosses_right : right.y < corner.y;
    part.edges.push_back(turns_below ? CellEdge{right, left} : CellEdge{left, right});
    if (crosses_right) std::swap(part.edges[begin + cross_line++], part.edges.back());
  }
  cell.begin = static_cast<std::uint32_t>(begin);
  cell.count = static_cast<std::uint8_t>(list.size());
  cell.cross_line = static_cast<std::uint8_t>(cross_line);
}

/// The parts one after another: first the cells of the whole grid, then all that are below them.
void GridBuilder::join(std::vector<Part>& parts, std::size_t cells_a_part) {
  struct Begin {
    std::size_t grids, cells, edges;
  };
  const std::size_t whole = grid_.cells_.size();
  std::vector<Begin> begins;
  Begin next{1, whole, 0};
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const std::size_t own = std::min(cells_a_part, whole - p * cells_a_part);
    begins.push_back(next);
    next = {next.grids + parts[p].grids.size(), next.cells + parts[p].cells.size() - own,
            next.edges + parts[p].edges.size()};
    grid_.has_crowds_ = grid_.has_crowds_ || parts[p].has_crowds;
  }
  check_count(std::max(next.cells, next.edges), "cells, or edges in cells");
  const Charge charge(2 * (next.grids * sizeof(Grid) + next.cells * sizeof(Cell) + next.edges * sizeof(CellEdge)));
  // A query looks at a few places anywhere: with small pages, at as many pages.
  reserve_in_large_pages(grid_.cells_, next.cells);
  reserve_in_large_pages(grid_.edges_, next.edges);
  grid_.grids_.resize(next.grids);
  grid_.cells_.resize(next.cells);
  grid_.edges_.resize(next.edges);
  for_ranges(parts.size(), 1, [&](std::size_t p, std::size_t end) {
    for (; p < end; ++p) {
      const Part part = std::move(parts[p]);
      const std::size_t own = std::min(cells_a_part, whole - p * cells_a_part);
      for (std::size_t c = 0; c < part.cells.size(); ++c) {
        Cell cell = part.cells[c];
        cell.begin += static_cast<std::uint32_t>(cell.kind == Cell::Kind::divided ? begins[p].grids : begins[p].edges);
        grid_.cells_[c < own ? p * cells_a_part + c : begins[p].cells + c - own] = cell;
      }
      for (std::size_t g = 0; g < part.grids.size(); ++g) {
        Grid grid = part.grids[g];
        grid.first_cell = static_cast<std::uint32_t>(begins[p].cells + grid.first_cell - own);
        grid_.grids_[begins[p].grids + g] = grid;
      }
      std::copy(part.edges.begin(), part.edges.end(),
                grid_.edges_.begin() + static_cast<std::ptrdiff_t>(begins[p].edges));
    }
  });
}

}  // namespace oblast::internal::locate
