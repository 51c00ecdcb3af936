#include "locate/cell_grid.h"

#include <algorithm>
#include <cmath>

#include "base/call.h"
#include "base/counting_sort.h"
#include "base/tuning.h"
#include "exact/orientation.h"

namespace oblast::internal::locate {
namespace {

using exact::orientation;

constexpr std::size_t most_entries = 0x7fffffff;  // twice as many have 32 bits

bool crosses(double from, double to, double after) { return (from <= after) != (to <= after); }

/// Whether an edge that crosses the line just below q does so left of what is just right of q. `side`: orientation of
/// its ends, as given, and q.
bool passes_left(const Point& from, const Point& to, int side) {
  if (side == 0) return from.y < to.y ? from.x <= to.x : to.x <= from.x;
  return (side < 0) == (from.y < to.y);
}

}  // namespace

std::size_t CellGrid::Lines::at(double value) const {
  const double guess = (value - first) * lines_a_unit;
  std::size_t line = guess > 0 ? std::min(static_cast<std::size_t>(guess), count - 1) : 0;
  // What was computed may be a line or two off; the lines themselves decide.
  while (line > 0 && value < (*this)[line]) --line;
  while (line + 1 < count && value >= (*this)[line + 1]) ++line;
  return line;
}

CellGrid::CellGrid(const Edges& edges) : edges_(edges) {
  if (edges.edges.empty()) return;
  const Point& first = edges.from(edges.edges[0]);
  box_ = Box::of(first, first);
  for (const Index e : edges.edges) box_ = box_.joined(edges.from(e));
  // Where an edge crosses a line is computed by six operations, each off by half a unit in its last place at most.
  margin_ = 0x1p-49 * (std::max(std::fabs(box_.x0), std::fabs(box_.x1)) + (box_.x1 - box_.x0));
  const std::size_t most =
      std::min(tuning::located_entries_an_edge * edges.edges.size() + tuning::located_cells_besides, most_entries);
  std::size_t cells = tuning::located_cells_an_edge * edges.edges.size() + tuning::located_cells_besides;
  choose_size(cells);
  while (!count_entries(most)) choose_size(cells /= 4);  // one cell has no more entries than there are edges
  list_edges();
  find_corners();
}

/// Cells about as high as they are wide, and not so narrow that their lines would coincide.
void CellGrid::choose_size(std::size_t cells) {
  const double width = box_.x1 - box_.x0, height = box_.y1 - box_.y0;
  const auto lines = [&](double extent, double other, double largest) {
    const double wanted = other > 0 ? std::sqrt(static_cast<double>(cells) * (extent / other)) : 1;
    const double most = std::min(static_cast<double>(cells), extent / (0x1p-48 * largest));
    return static_cast<std::size_t>(std::max(1.0, std::floor(std::min(wanted, most))));
  };
  const std::size_t columns = lines(width, height, std::max(std::fabs(box_.x0), std::fabs(box_.x1)));
  const std::size_t rows =
      std::min(lines(height, width, std::max(std::fabs(box_.y0), std::fabs(box_.y1))), cells / columns + 1);
  columns_ = Lines(box_.x0, width, columns);
  rows_ = Lines(box_.y0, height, rows);
}

template <class Visit>
void CellGrid::for_each_row(Index edge, const Visit& visit) const {
  const Point &low = edges_.lower(edge), &high = edges_.upper(edge);
  const double left = std::min(low.x, high.x), right = std::max(low.x, high.x);
  const std::size_t last_row = rows_.at(high.y);
  const double dx = high.x - low.x, dy = high.y - low.y;
  const auto crossing = [&](std::size_t row) { return low.x + dx * ((rows_[row] - low.y) / dy); };
  double from = low.x;
  for (std::size_t row = rows_.at(low.y); row <= last_row; ++row) {
    const double to = row == last_row ? high.x : crossing(row + 1);
    const double first = std::max(left, std::min(from, to) - margin_);
    const double last = std::min(right, std::max(from, to) + margin_);
    visit(row, columns_.at(first), columns_.at(last) + 1);
    from = to;
  }
}

/// By cell, how many edges its list will have; false as soon as there are more than `most` in all.
bool CellGrid::count_entries(std::size_t most) {
  cells_.assign(columns_.count * rows_.count + 1, 0);
  Steps steps(edges_.edges.size());
  std::size_t entries = 0;
  for (const Index e : edges_.edges) {
    steps();
    for_each_row(e, [&](std::size_t row, std::size_t column, std::size_t past) {
      entries += past - column;
      for (; column < past && entries <= most; ++column) ++cells_[row * columns_.count + column];
    });
    if (entries > most) return false;
  }
  return true;
}

void CellGrid::list_edges() {
  has_crowds_ = std::any_of(cells_.begin(), cells_.end(),
                            [](std::uint32_t count) { return count > tuning::looked_at_in_a_cell; });
  lists_.resize(counts_to_begins(cells_));
  Steps steps(edges_.edges.size());
  const auto for_each_entry = [&](const auto& visit) {
    for (const Index e : edges_.edges) {
      steps();
      for_each_row(e, [&](std::size_t row, std::size_t column, std::size_t past) {
        for (; column < past; ++column) visit(row * columns_.count + column, e);
      });
    }
  };
  put_in_places(cells_, for_each_entry, [&](std::size_t slot, Index e) { lists_[slot] = e; });
  // The end of a cell is the begin of the next one, shifted by one bit to make room for the corner's.
  for (std::size_t c = cells_.size() - 1; c > 0; --c) cells_[c] = 2 * cells_[c - 1];
  cells_[0] = 0;
}

/// Of the corners along a row's lower line, which the edge crosses: the first that it passes left of.
std::size_t CellGrid::first_corner_right_of(Index edge, double y) const {
  const Point &from = edges_.from(edge), &to = edges_.to(edge);
  const auto is_right = [&](std::size_t column) {
    const double x = columns_[column];
    if (std::min(from.x, to.x) > x) return false;
    if (std::max(from.x, to.x) <= x) return true;
    return passes_left(from, to, orientation(from, to, {x, y}));
  };
  std::size_t column = columns_.at(from.x + (to.x - from.x) * ((y - from.y) / (to.y - from.y)));
  while (column > 0 && is_right(column - 1)) --column;
  while (column < columns_.count && !is_right(column)) ++column;
  return column;
}

void CellGrid::find_corners() {
  for (const Index e : edges_.edges) {
    const double low = edges_.lower(e).y, high = edges_.upper(e).y;
    for (std::size_t row = rows_.at(low), last = rows_.at(high); row <= last; ++row) {
      const double y = rows_[row];
      if (!(low < y && y <= high)) continue;
      const std::size_t column = first_corner_right_of(e, y);
      if (column < columns_.count) cells_[row * columns_.count + column] ^= 1;
    }
  }
  for (std::size_t row = 0; row < rows_.count; ++row)
    for (std::size_t c = row * columns_.count + 1; c < (row + 1) * columns_.count; ++c) cells_[c] ^= cells_[c - 1] & 1;
}

CellAnswer CellGrid::locate(const Point& p) const {
  if (!box_.contains(p) || cells_.empty()) return CellAnswer::outside;
  const std::size_t column = columns_.at(p.x), row = rows_.at(p.y), cell = row * columns_.count + column;
  bool inside = (cells_[cell] & 1) != 0;
  const std::uint32_t begin = cells_[cell] >> 1, end = cells_[cell + 1] >> 1;
  if (end - begin > tuning::looked_at_in_a_cell) return CellAnswer::crowded;
  if (begin == end) return inside ? CellAnswer::inside : CellAnswer::outside;
  const Point q{p.x, rows_[row]}, corner{columns_[column], q.y};
  for (std::uint32_t i = begin; i < end; ++i) {
    const Point &from = edges_.from(lists_[i]), &to = edges_.to(lists_[i]);
    const auto [left, right] = std::minmax(from.x, to.x);
    const auto [low, high] = std::minmax(from.y, to.y);
    const bool over = crosses(from.x, to.x, p.x), across = (from.y < q.y) != (to.y < q.y);
    const bool rightward = from.x < to.x;
    // Only where a box holds a point the exact side is asked for.
    bool below_p = p.y > high;
    if (p.y >= low && p.y <= high && p.x >= left && p.x <= right) {
      const int side = orientation(from, to, p);
      if (side == 0) return CellAnswer::boundary;
      below_p = (side > 0) == rightward;
    }
    bool below_q = q.y > high, left_of_q = right <= q.x;
    if ((over || across) && q.y >= low && q.y <= high && q.x >= left && q.x < right) {
      const int side = orientation(from, to, q);
      below_q = side != 0 && (side > 0) == rightward;
      left_of_q = passes_left(from, to, side);
    }
    inside ^= over && below_p != below_q;
    if (!across || left > q.x) continue;
    bool left_of_corner = right <= corner.x;
    if (!left_of_corner && left <= corner.x) left_of_corner = passes_left(from, to, orientation(from, to, corner));
    inside ^= left_of_q != left_of_corner;
  }
  return inside ? CellAnswer::inside : CellAnswer::outside;
}

}  // namespace oblast::internal::locate
