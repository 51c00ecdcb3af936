#include "locate/parted_box.h"

#include <algorithm>
#include <cmath>

namespace oblast::internal::locate {

PartedBox::PartedBox(const Box& box, double margin_x, double margin_y, std::size_t cells) {
  const double width = box.x1 - box.x0, height = box.y1 - box.y0;
  const auto lines = [&](double extent, double other, double margin) {
    const double wanted = other > 0 ? std::sqrt(static_cast<double>(cells) * (extent / other)) : 1;
    const double most =
        std::min({static_cast<double>(cells), PartedAxis::most_columns(extent, margin), double{0x7fffffff}});
    // Nothing divided by nothing is not a number.
    return extent > 0 ? static_cast<std::size_t>(std::max(1.0, std::floor(std::min(wanted, most)))) : 1;
  };
  const std::size_t column_count = lines(width, height, margin_x);
  const std::size_t row_count = std::min(lines(height, width, margin_y), cells / column_count + 1);
  columns = PartedAxis(box.x0, box.x1, margin_x, column_count);
  rows = PartedAxis(box.y0, box.y1, margin_y, row_count);
}

Grid PartedBox::grid(std::size_t first_cell) const {
  return {columns.lines(), rows.lines(), static_cast<std::uint32_t>(first_cell)};
}

namespace {

/// Calls visit(row, first column, past the last column) with all cells that the edge comes by, and maybe others.
template <class Visit>
void for_each_row(const Edges& edges, Index edge, const PartedBox& parted, const Visit& visit) {
  const PartedAxis &columns = parted.columns, &rows = parted.rows;
  const Point &low = edges.lower(edge), &high = edges.upper(edge);
  const auto [left, right] = std::minmax(low.x, high.x);
  const double slope = low.y < high.y ? (high.x - low.x) / (high.y - low.y) : 0;
  const double first_x = columns.line(0), end_x = columns.end_of(columns.count() - 1);
  for (std::size_t row = rows.first_by(low.y), last = rows.last_by(high.y); row <= last; ++row) {
    const double y0 = rows.line(row), y1 = rows.end_of(row);
    if (y0 > high.y || y1 < low.y) continue;
    const double from = y0 <= low.y ? low.x : low.x + (y0 - low.y) * slope;
    const double to = y1 >= high.y ? high.x : low.x + (y1 - low.y) * slope;
    const double x0 = std::max(left, std::min(from, to) - columns.margin());
    const double x1 = std::min(right, std::max(from, to) + columns.margin());
    if (x0 <= end_x && x1 >= first_x) visit(row, columns.first_by(x0), columns.last_by(x1) + 1);
  }
}

}  // namespace

bool list_by_cell(const Edges& edges, std::span<const Index> list, const PartedBox& parted, std::size_t most,
                  CellLists& lists, Steps* steps) {
  const std::size_t columns = parted.columns.count();
  std::vector<Index>& begins = lists.begins;
  begins.assign(parted.cells() + 1, 0);
  std::size_t entries = 0;
  for (const Index e : list) {
    if (steps) (*steps)();
    for_each_row(edges, e, parted, [&](std::size_t row, std::size_t column, std::size_t past) {
      entries += past - column;
      for (; column < past && entries <= most; ++column) ++begins[row * columns + column];
    });
    if (entries > most) return false;
  }
  // Each beginning is its end first, and is moved down.
  for (std::size_t c = 1; c < begins.size(); ++c) begins[c] += begins[c - 1];
  lists.items.resize(entries);
  for (const Index e : list) {
    if (steps) (*steps)();
    for_each_row(edges, e, parted, [&](std::size_t row, std::size_t column, std::size_t past) {
      for (; column < past; ++column) lists.items[--begins[row * columns + column]] = e;
    });
  }
  return true;
}

}  // namespace oblast::internal::locate
