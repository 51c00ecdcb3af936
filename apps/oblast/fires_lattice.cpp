// The pixels of a pass: lookup, connected components, outlines.
#include "oblast/fires_lattice.h"

#include <algorithm>
#include <cmath>

namespace oblast::app {

namespace {

// A component as a bitmap that is one pixel wider on every side than its bounding box.
class Frame {
 public:
  explicit Frame(const std::vector<Cell>& cells) {
    low_ = high_ = cells.front();
    for (const Cell& c : cells) {
      low_ = {std::min(low_.i, c.i), std::min(low_.j, c.j)};
      high_ = {std::max(high_.i, c.i), std::max(high_.j, c.j)};
    }
    low_ = {low_.i - 1, low_.j - 1};
    columns_ = static_cast<std::size_t>(high_.i + 2 - low_.i);
    rows_ = static_cast<std::size_t>(high_.j + 2 - low_.j);
    inside_.assign(columns_ * rows_, 0);
    for (const Cell& c : cells) inside_[index(c)] = 1;
  }

  bool inside(Cell c) const { return inside_[index(c)] != 0; }

  // Cells that the outside does not reach through sides become inside.
  void fill_gaps() {
    std::vector<std::uint8_t> outside(inside_.size(), 0);
    std::vector<std::size_t> pending{0};
    outside[0] = 1;
    while (!pending.empty()) {
      const std::size_t at = pending.back();
      pending.pop_back();
      const std::size_t column = at % columns_, row = at / columns_;
      const auto visit = [&](std::size_t next) {
        if (outside[next] || inside_[next]) return;
        outside[next] = 1;
        pending.push_back(next);
      };
      if (column > 0) visit(at - 1);
      if (column + 1 < columns_) visit(at + 1);
      if (row > 0) visit(at - columns_);
      if (row + 1 < rows_) visit(at + columns_);
    }
    for (std::size_t k = 0; k < inside_.size(); ++k) inside_[k] = !outside[k];
  }

  std::vector<Cell> cells() const {
    std::vector<Cell> result;
    for (std::int32_t i = low_.i; i <= high_.i; ++i) {
      for (std::int32_t j = low_.j; j <= high_.j; ++j) {
        if (inside({i, j})) result.push_back({i, j});
      }
    }
    return result;
  }

 private:
  std::size_t index(Cell c) const {
    return static_cast<std::size_t>(c.j - low_.j) * columns_ + static_cast<std::size_t>(c.i - low_.i);
  }

  Cell low_, high_;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<std::uint8_t> inside_;
};

}  // namespace

Lattice::Lattice(Point origin, double slope, double width_km, double height_km)
    : origin_(origin),
      cosine_((1 - slope * slope) / (1 + slope * slope)),  // sin and cos differ between machines
      sine_(2 * slope / (1 + slope * slope)),
      width_(width_km),
      height_(height_km),
      u_{width_km * cosine_ / km_per_degree_lon, width_km * sine_ / km_per_degree_lat},
      v_{-height_km * sine_ / km_per_degree_lon, height_km * cosine_ / km_per_degree_lat} {}

Cell Lattice::cell_at(Point place) const {
  const double x = (place.x - origin_.x) * km_per_degree_lon, y = (place.y - origin_.y) * km_per_degree_lat;
  return {static_cast<std::int32_t>(std::floor((x * cosine_ + y * sine_) / width_)),
          static_cast<std::int32_t>(std::floor((y * cosine_ - x * sine_) / height_))};
}

std::vector<Cell> Lattice::disc(Point place, double radius_km) const {
  const double x = (place.x - origin_.x) * km_per_degree_lon, y = (place.y - origin_.y) * km_per_degree_lat;
  const double along = x * cosine_ + y * sine_, across = y * cosine_ - x * sine_;
  const Cell centre = cell_at(place);
  const auto reach_i = static_cast<std::int32_t>(radius_km / width_) + 1;
  const auto reach_j = static_cast<std::int32_t>(radius_km / height_) + 1;
  std::vector<Cell> cells;
  for (std::int32_t i = centre.i - reach_i; i <= centre.i + reach_i; ++i) {
    for (std::int32_t j = centre.j - reach_j; j <= centre.j + reach_j; ++j) {
      const double di = (i + 0.5) * width_ - along, dj = (j + 0.5) * height_ - across;
      if (di * di + dj * dj <= radius_km * radius_km) cells.push_back({i, j});
    }
  }
  return cells;
}

std::vector<Cell> without_gaps(const std::vector<Cell>& cells) {
  if (cells.empty()) return {};
  Frame frame(cells);
  frame.fill_gaps();
  return frame.cells();
}

std::vector<std::vector<Cell>> components(const std::vector<Cell>& cells) {
  std::vector<std::vector<Cell>> result;
  std::vector<std::uint8_t> seen(cells.size(), 0);
  std::vector<std::size_t> pending;
  for (std::size_t first = 0; first < cells.size(); ++first) {
    if (seen[first]) continue;
    std::vector<Cell> component;
    pending.push_back(first);
    seen[first] = 1;
    while (!pending.empty()) {
      const Cell c = cells[pending.back()];
      pending.pop_back();
      component.push_back(c);
      for (const Cell next : {Cell{c.i - 1, c.j}, Cell{c.i + 1, c.j}, Cell{c.i, c.j - 1}, Cell{c.i, c.j + 1}}) {
        const auto found = std::lower_bound(cells.begin(), cells.end(), next);
        if (found == cells.end() || *found != next) continue;
        const auto k = static_cast<std::size_t>(found - cells.begin());
        if (seen[k]) continue;
        seen[k] = 1;
        pending.push_back(k);
      }
    }
    std::sort(component.begin(), component.end());
    result.push_back(std::move(component));
  }
  return result;
}

std::vector<OutlineVertex> outline(const std::vector<Cell>& component) {
  const Frame frame(component);
  // The walk starts below the first pixel (smallest column, then row) and keeps the component on its left.
  // It is always at a corner. Headings: 0 east, 1 north, 2 west, 3 south.
  const Cell start = *std::min_element(component.begin(), component.end());
  static constexpr Cell step[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  // For each heading: the pixel ahead on the left, and the pixel ahead on the right, of the corner.
  static constexpr Cell left[4] = {{0, 0}, {-1, 0}, {-1, -1}, {0, -1}};
  static constexpr Cell right[4] = {{0, -1}, {0, 0}, {-1, 0}, {-1, -1}};
  std::vector<OutlineVertex> result;
  Cell at = start;
  int heading = 0;
  do {
    at = {at.i + step[heading].i, at.j + step[heading].j};
    const bool on_left = frame.inside({at.i + left[heading].i, at.j + left[heading].j});
    const bool on_right = frame.inside({at.i + right[heading].i, at.j + right[heading].j});
    const int before = heading;
    if (on_right) {
      heading = (heading + 3) % 4;
    } else if (!on_left) {
      heading = (heading + 1) % 4;
    }
    result.push_back({at, heading == before});
  } while (at != start);
  return result;
}

}  // namespace oblast::app
