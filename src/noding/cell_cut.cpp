#include "noding/cell_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/tuning.h"
#include "exact/orientation.h"

namespace oblast::internal::noding {
namespace {

// Rounding. One operation is off by at most u = epsilon / 2, relative to its value. Terms of u * u are left out below:
// every bound has at least a quarter of its size to spare for them.
constexpr double epsilon = std::numeric_limits<double>::epsilon();

bool reaches_left(double low, const CellCut& cut) { return low < cut.at; }
bool reaches_right(double high, const CellCut& cut) { return high >= cut.at; }

/// The box of the edge from p to q between the parameters s and t, widened by the run's margin and by the rounding of
/// its computation, within the box of what of the edge is in the cell. Empty where that part is not in the cell. Parts
/// are computed from the whole edge each time, so that their rounding does not add up from cut to cut.
///
/// Rounding: p.x + (q.x - p.x) u has three operations. The difference and the product are off by 2 u |q.x - p.x| at
/// most, the sum by u max(|p.x|, |q.x|), and moving the result by the margin by as much again. That makes 4 u (|p.x| +
/// |q.x|), half of what is allowed for. (The margin's own rounding is 2 u of the margin; clearance.h has room for a
/// fifth of it.)
Box part_of(const Point& p, const Point& q, double s, double t, const Run& run) {
  const Box& whole = run.box;
  s = std::clamp(s, 0.0, 1.0);
  t = std::clamp(t, 0.0, 1.0);
  const auto at = [&](double u) { return Point{p.x + (q.x - p.x) * u, p.y + (q.y - p.y) * u}; };
  const Box box = Box::of(at(s), at(t));
  const double x_margin = run.margin() + 4 * epsilon * (std::fabs(p.x) + std::fabs(q.x));
  const double y_margin = run.margin() + 4 * epsilon * (std::fabs(p.y) + std::fabs(q.y));
  return {std::max(box.x0 - x_margin, whole.x0), std::max(box.y0 - y_margin, whole.y0),
          std::min(box.x1 + x_margin, whole.x1), std::min(box.y1 + y_margin, whole.y1)};
}

bool is_empty(const Box& box) { return box.x0 > box.x1 || box.y0 > box.y1; }

/// At a value of x or y the edge has the parameter T = (cut.at - from) / (to - from). What is within the margin of the
/// left side ends at T + M, with M = margin / |to - from|.
///
/// Rounding: t, computed by three operations, is off by 3 u |T|; M by 2 u M, and its sum with the rest by u M. The sum
/// t + error is at most 1, or it is clamped to 1, so it is off by u. Together 3 u |T| + 3 u M + u. Where M > |T| + 1,
/// the sum is clamped in any case; else this is at most 6 u |T| + 4 u. Allowed for are 8 u (1 + |T|).
Sides divide_at_value(const Point& p, const Point& q, const Run& run, const CellCut& cut) {
  Sides sides = divide_run({}, run, cut);
  if (!sides.left || !sides.right) return sides;
  const bool x = cut.kind == CutKind::at_x;
  const double from = x ? p.x : p.y, to = x ? q.x : q.y;
  if (from == to) return sides;
  const double t = (cut.at - from) / (to - from);
  const double error = 4 * epsilon * (1 + (std::fabs(from) + std::fabs(cut.at)) / std::fabs(to - from)) +
                       run.margin() / std::fabs(to - from);
  const bool p_left = from < to;
  (p_left ? sides.left_part.box : sides.right_part.box) = part_of(p, q, 0, t + error, run);
  (p_left ? sides.right_part.box : sides.left_part.box) = part_of(p, q, t - error, 1, run);
  return sides;
}

/// Keeps the edge c d from a side of the line (a, b) that it does not reach, by exact predicates. This is for edges
/// without a margin, and for those that touch (a, b) in a vertex, if they may be on one side only
/// (CellCut::parts_touching).
///
/// An edge that only touches the line stays on one side, if it does so on the cut's own edge: whatever it meets there,
/// that edge meets too, and it is on both sides.
void keep_to_exact_side(const Point& a, const Point& b, const Point& c, const Point& d, int c_side, int d_side,
                        const Run& run, const CellCut& cut, Sides& sides) {
  const Box own = Box::of(a, b);
  const auto touches_elsewhere = [&](int side, const Point& p) { return side == 0 && !own.contains(p); };
  const auto touches_here = [&](int side, const Point& p) { return side == 0 && run.box.contains(p); };
  if (touches_elsewhere(c_side, c) || touches_elsewhere(d_side, d)) return;
  const bool touches = touches_here(c_side, c) || touches_here(d_side, d);
  if (run.margin() != 0 && !(touches && cut.parts_touching)) return;
  if (c_side >= 0 && d_side >= 0) sides.right = false;
  if (c_side <= 0 && d_side <= 0) sides.left = false;
  sides.touches = touches && !(sides.left && sides.right);
}

/// Clips the edge c d at the line (a, b) in floating point.
///
///        c                     P, Q: twice the areas of (a, b, c) and (a, b, d), above 0 on the left
///     ---- \ ------------ b    T = P / (P - Q): where c d meets the line. The margin becomes a strip along the line,
///     a      d                 in the same measure at least its width times the length of (a, b)
///
/// Rounding: an area is the difference of two products. Each product has two rounded factors, so it is off by 3 u, and
/// the difference by u more. With |p.y - a.y| <= |p.y| + |a.y|, and the same in x, both are off by at most e = 4 u
/// (|dx|
/// (|p.y| + |a.y|) + |dy| (|p.x| + |a.x|)). Allowed for are 4 e, so as to have error = 4 e + strip.
///
/// Once the ends are not both further left of the line than `error`, nor both further right, and |p - q| > 4 error, T
/// is between -1 and 2. So t is off by at most (|1 - T| + |T|) e / |p - q| <= 3 e / |p - q|, and the strip ends within
/// 2 strip / |p - q| of T: together less than 4 error / |p - q|. The division and the sums, of values up to 1 where
/// they are not clamped, are off by 6 u at most; allowed for are 8 u.
Sides clip_at_line(const Point& a, const Point& b, const Point& c, const Point& d, const Run& run, Sides sides) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const auto area = [&](const Point& p) { return dx * (p.y - a.y) - dy * (p.x - a.x); };
  const auto error_at = [&](const Point& p) {
    return 8 * epsilon *
           (std::fabs(dx) * (std::fabs(p.y) + std::fabs(a.y)) + std::fabs(dy) * (std::fabs(p.x) + std::fabs(a.x)));
  };
  const double strip = run.margin() * (std::fabs(dx) + std::fabs(dy));
  const double p = area(c), q = area(d), error = std::max(error_at(c), error_at(d)) + strip;
  if (p > error && q > error) sides.right = false;
  if (p < -error && q < -error) sides.left = false;
  if (!sides.left || !sides.right || std::fabs(p - q) <= 4 * error) return sides;
  const double t = p / (p - q), t_error = 4 * error / std::fabs(p - q) + 4 * epsilon;
  (p > q ? sides.left_part.box : sides.right_part.box) = part_of(c, d, 0, t + t_error, run);
  (p > q ? sides.right_part.box : sides.left_part.box) = part_of(c, d, t - t_error, 1, run);
  sides.left = !is_empty(sides.left_part.box);
  sides.right = !is_empty(sides.right_part.box);
  return sides;
}

Sides divide_along_edge(std::span<const Point> points, const Point& c, const Point& d, const Run& run,
                        const CellCut& cut) {
  Sides sides{true, true, run, run};
  const Point &a = points[cut.edge], &b = points[cut.edge + 1];
  const int c_side = exact::orientation(a, b, c), d_side = exact::orientation(a, b, d);
  if (c_side == 0 && d_side == 0) return sides;
  keep_to_exact_side(a, b, c, d, c_side, d_side, run, cut, sides);
  if (!sides.left || !sides.right) return sides;
  return clip_at_line(a, b, c, d, run, sides);
}

}  // namespace

Sides divide_run(std::span<const Point> points, const Run& run, const CellCut& cut) {
  Sides sides{reaches_left(low(run.box, cut.kind), cut), reaches_right(high(run.box, cut.kind), cut), run, run};
  if (!sides.left || !sides.right || run.last - run.first < tuning::shortest_divided_run || points.empty())
    return sides;
  const auto value = [&](std::uint32_t vertex) {
    return cut.kind == CutKind::at_x ? points[vertex].x : points[vertex].y;
  };
  const bool rising = value(run.first) <= value(run.last);
  const double margin = run.margin();
  const auto left = [&](double v) { return reaches_left(v - margin, cut); };
  const auto right = [&](double v) { return reaches_right(v + margin, cut); };
  const auto reaches_start = [&](double v) { return rising ? left(v) : right(v); };
  const auto reaches_end = [&](double v) { return rising ? right(v) : left(v); };
  Run &start = rising ? sides.left_part : sides.right_part, &end = rising ? sides.right_part : sides.left_part;
  while (!reaches_end(value(end.first + 1))) ++end.first;
  start.last = end.first + 1;
  while (start.last < run.last && reaches_start(value(start.last))) ++start.last;
  start.box = Box::of(points[start.first], points[start.last]).widened(margin);
  end.box = Box::of(points[end.first], points[end.last]).widened(margin);
  return sides;
}

std::size_t divide_runs(std::span<const Point> points, LargeArray<Run>& runs, std::size_t begin, const CellCut& cut,
                        LargeArray<Run>& right) {
  // Where a run lies is hard to foresee, so a block of them is sorted out first, without branches.
  constexpr std::size_t block = tuning::divided_runs_a_block;
  std::array<std::uint8_t, block> on_left, on_right_only;
  std::size_t left_end = begin;
  for (std::size_t first = begin, size; first < runs.size(); first += size) {
    size = std::min(block, runs.size() - first);
    std::size_t lefts = 0, rights = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const bool left = reaches_left(low(runs[first + i].box, cut.kind), cut);
      on_left[lefts] = on_right_only[rights] = static_cast<std::uint8_t>(i);
      lefts += left;
      rights += !left;
    }
    for (std::size_t i = 0; i < rights; ++i) right.push_back(runs[first + on_right_only[i]]);
    for (std::size_t i = 0; i < lefts; ++i) {
      const Run e = runs[first + on_left[i]];
      if (!reaches_right(high(e.box, cut.kind), cut)) {
        runs[left_end++] = e;
        continue;
      }
      const Sides sides = divide_run(points, e, cut);
      runs[left_end++] = sides.left_part;
      right.push_back(sides.right_part);
    }
  }
  return left_end;
}

Sides divide_edge(std::span<const Point> points, const Run& run, const CellCut& cut) {
  const Point &p = points[run.first], &q = points[run.first + 1];
  return cut.kind == CutKind::along_edge ? divide_along_edge(points, p, q, run, cut) : divide_at_value(p, q, run, cut);
}

}  // namespace oblast::internal::noding
