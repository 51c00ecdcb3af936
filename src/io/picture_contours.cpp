// Clips contours to the panel, snaps them to a lattice of a tenth of a pixel or coarser, removes vertices that have
// become redundant, and shows contours smaller than a pixel as dots.
#include "io/picture_contours.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <vector>

namespace oblast::io {

namespace {

// Opacity of a dot by the share of it that is covered; a lone speck stays visible.
struct Density {
  double least_share;
  double opacity;
};
constexpr Density densities[] = {{0, 0.45}, {0.15, 0.6}, {0.35, 0.75}, {0.6, 0.9}, {0.85, 1}};

constexpr double clip_margin = 5;  // pixels beyond the panel; the edges made by clipping are invisible there

struct Snapped {  // tenths of a pixel
  std::int64_t x = 0, y = 0;
  friend bool operator==(const Snapped&, const Snapped&) = default;
};

// Sutherland and Hodgman, one side of a box: keeps what lies at `sign * coordinate >= sign * limit`.
void clip_side(const std::vector<Point>& in, std::vector<Point>& out, double Point::*axis, double Point::*other,
               double limit, double sign) {
  out.clear();
  for (std::size_t k = 0; k < in.size(); ++k) {
    const Point& p = in[k == 0 ? in.size() - 1 : k - 1];
    const Point& q = in[k];
    const bool p_in = sign * (p.*axis) >= sign * limit, q_in = sign * (q.*axis) >= sign * limit;
    if (p_in != q_in) {
      Point cut;
      cut.*axis = limit;
      cut.*other = p.*other + (q.*other - p.*other) * ((limit - p.*axis) / (q.*axis - p.*axis));
      out.push_back(cut);
    }
    if (q_in) out.push_back(q);
  }
}

// One panel's drawing of one view at one lattice step.
class Drawing {
 public:
  Drawing(const RegionView& view, const Frame& frame, DrawAs as, double dot, std::size_t budget, double step)
      : view_(view), frame_(frame), as_(as), dot_(dot), budget_(budget), step_(step), smallest_(std::max(1.0, step)) {}

  /// False when the budget was exceeded before the end, unless `keep_going`.
  bool run(bool keep_going) {
    for (std::size_t p = 0; p < view_.polygon_count(); ++p) {
      std::string path;
      for (std::uint32_t c = view_.polygon_begin(p); c < view_.polygon_end(p); ++c) draw(c, path);
      if (path.empty()) continue;
      if (size() + path.size() + 16 > budget_) {
        if (!keep_going) return false;
        --result_.drawn;
        ++result_.left_out;
        continue;
      }
      if (as_ == DrawAs::polygons) {
        result_.polygons += "<path d=\"" + path + "\"/>\n";
      } else {
        result_.outlines += path + '\n';
      }
    }
    draw_dots();
    return keep_going || size() + result_.dots.size() <= budget_;
  }

  DrawnContours& result() { return result_; }

 private:
  std::size_t size() const { return result_.polygons.size() + result_.outlines.size(); }

  // The area of the contour in square pixels. A hole below a pixel counts, too: it is rare.
  double covered() const {
    double sum = 0;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      const Point& p = points_[k == 0 ? points_.size() - 1 : k - 1];
      const Point& q = points_[k];
      sum += (p.x - points_[0].x) * (q.y - points_[0].y) - (q.x - points_[0].x) * (p.y - points_[0].y);
    }
    return std::fabs(sum) / 2;
  }

  void draw(std::uint32_t contour, std::string& path) {
    const double left = frame_.box.left - clip_margin, right = frame_.box.left + frame_.box.width + clip_margin;
    const double top = frame_.box.top - clip_margin, bottom = frame_.box.top + frame_.box.height + clip_margin;
    double x0 = HUGE_VAL, y0 = HUGE_VAL, x1 = -HUGE_VAL, y1 = -HUGE_VAL;
    points_.clear();
    for (const Point& p : view_.contour(contour)) {
      const Point q{frame_.px(p.x), frame_.py(p.y)};
      x0 = std::min(x0, q.x), x1 = std::max(x1, q.x);
      y0 = std::min(y0, q.y), y1 = std::max(y1, q.y);
      points_.push_back(q);
    }
    if (points_.empty() || x1 < left || x0 > right || y1 < top || y0 > bottom) return;
    if (x1 - x0 < smallest_ && y1 - y0 < smallest_) {
      gather((x0 + x1) / 2, (y0 + y1) / 2, covered());
      return;
    }
    if (x0 < left) clip_side(points_, scratch_, &Point::x, &Point::y, left, 1), points_.swap(scratch_);
    if (x1 > right) clip_side(points_, scratch_, &Point::x, &Point::y, right, -1), points_.swap(scratch_);
    if (y0 < top) clip_side(points_, scratch_, &Point::y, &Point::x, top, 1), points_.swap(scratch_);
    if (y1 > bottom) clip_side(points_, scratch_, &Point::y, &Point::x, bottom, -1), points_.swap(scratch_);
    snap();
    if (snapped_.size() < 3) {
      gather((x0 + x1) / 2, (y0 + y1) / 2, covered());
      return;
    }
    ++result_.drawn;
    append_path(path);
  }

  // Removes vertices that coincide, lie on the line through their neighbours, or make a spike.
  void snap() {
    const double tenths = std::round(step_ * 10);
    snapped_.clear();
    for (const Point& p : points_) {
      push({static_cast<std::int64_t>(std::round(p.x * 10 / tenths) * tenths),
            static_cast<std::int64_t>(std::round(p.y * 10 / tenths) * tenths)});
    }
    while (snapped_.size() > 1 && snapped_.front() == snapped_.back()) snapped_.pop_back();
  }

  void push(Snapped next) {
    while (!snapped_.empty()) {
      if (snapped_.back() == next) return;
      if (snapped_.size() < 2) break;
      const Snapped a = snapped_[snapped_.size() - 2], b = snapped_.back();
      if ((b.x - a.x) * (next.y - a.y) != (b.y - a.y) * (next.x - a.x)) break;
      snapped_.pop_back();
    }
    snapped_.push_back(next);
  }

  void append_path(std::string& path) const {
    path += 'M' + std::to_string(snapped_[0].x) + ' ' + std::to_string(snapped_[0].y) + 'l';
    for (std::size_t k = 1; k < snapped_.size(); ++k) {
      const std::int64_t dx = snapped_[k].x - snapped_[k - 1].x, dy = snapped_[k].y - snapped_[k - 1].y;
      if (k > 1 && dx >= 0) path += ' ';
      path += std::to_string(dx);
      if (dy >= 0) path += ' ';
      path += std::to_string(dy);
    }
    path += 'z';
  }

  void gather(double x, double y, double area) {
    ++result_.gathered;
    dots_[{static_cast<std::int64_t>(std::floor(y / dot_)), static_cast<std::int64_t>(std::floor(x / dot_))}] += area;
  }

  std::size_t density_of(double area) const {
    std::size_t density = 0;
    while (density + 1 < std::size(densities) && area / (dot_ * dot_) >= densities[density + 1].least_share) ++density;
    return density;
  }

  // Adjacent dots of the same density in a row become one rectangle.
  void draw_dots() {
    const auto side = static_cast<std::int64_t>(std::round(dot_ * 10));
    std::string paths[std::size(densities)];
    for (auto run = dots_.begin(); run != dots_.end();) {
      const std::size_t density = density_of(run->second);
      auto end = std::next(run);
      std::int64_t length = 1;
      while (end != dots_.end() && end->first.first == run->first.first &&
             end->first.second == run->first.second + length && density_of(end->second) == density) {
        ++end;
        ++length;
      }
      std::string& path = paths[density];
      path += 'M' + std::to_string(run->first.second * side) + ' ' + std::to_string(run->first.first * side);
      path += 'h' + std::to_string(length * side) + 'v' + std::to_string(side) + 'h' + std::to_string(-length * side) +
              "z\n";
      run = end;
    }
    for (std::size_t i = 0; i < std::size(densities); ++i) {
      if (paths[i].empty()) continue;
      result_.dots += "<path stroke=\"none\" opacity=\"" + std::to_string(densities[i].opacity).substr(0, 4) +
                      "\" d=\"" + paths[i] + "\"/>\n";
    }
  }

  const RegionView& view_;
  const Frame& frame_;
  DrawAs as_;
  double dot_;
  std::size_t budget_;
  double step_, smallest_;
  std::vector<Point> points_, scratch_;
  std::vector<Snapped> snapped_;
  std::map<std::pair<std::int64_t, std::int64_t>, double> dots_;  // (row, column): covered, in square pixels
  DrawnContours result_;
};

}  // namespace

DrawnContours draw_contours(const RegionView& view, const Frame& frame, DrawAs as, double dot, std::size_t most_bytes) {
  for (const double step : {0.1, 0.3, 1.0, 3.0}) {
    Drawing drawing(view, frame, as, dot, most_bytes, step);
    if (drawing.run(false)) return std::move(drawing.result());
  }
  Drawing drawing(view, frame, as, 2 * dot, most_bytes, 8.0);
  drawing.run(true);
  return std::move(drawing.result());
}

}  // namespace oblast::io
