#include "noding/cell_cut.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/call_memory.h"
#include "base/tuning.h"
#include "exact/orientation.h"
#include "plane/point_hash.h"

namespace oblast::internal::noding {
namespace {

constexpr std::size_t sample_size = tuning::cut_sample;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// REQUIRES: at_x or at_y.
Axis axis_of(CutKind kind) { return kind == CutKind::at_x ? Axis::x : Axis::y; }
double low(const Box& box, CutKind kind) { return low(box, axis_of(kind)); }
double high(const Box& box, CutKind kind) { return high(box, axis_of(kind)); }

bool reaches_left(double low, const CellCut& cut) { return low < cut.at; }
bool reaches_right(double high, const CellCut& cut) { return high >= cut.at; }

/// The whole edge, whatever of it is in the cell: parts are computed from it each time, so that their rounding does not
/// add up from cut to cut. Both coordinates are monotone along it, so a part of it is the part of its box.
struct Fragment {
  Point p, q;
};

Fragment fragment_of(std::span<const Point> points, const Entry& e) { return {points[e.first], points[e.first + 1]}; }

/// The box of the edge between parameters s and t, widened by its margin and the rounding of its computation, within
/// the box of what of it is in the cell. Empty where that part is not in the cell.
Box part_of(const Fragment& f, double s, double t, const Entry& entry) {
  const Box& whole = entry.box;
  s = std::clamp(s, 0.0, 1.0);
  t = std::clamp(t, 0.0, 1.0);
  const auto at = [&](double u) { return Point{f.p.x + (f.q.x - f.p.x) * u, f.p.y + (f.q.y - f.p.y) * u}; };
  Box box = Box::of(at(s), at(t));
  const double x_margin = entry.margin() + 4 * epsilon * (std::fabs(f.p.x) + std::fabs(f.q.x));
  const double y_margin = entry.margin() + 4 * epsilon * (std::fabs(f.p.y) + std::fabs(f.q.y));
  return {std::max(box.x0 - x_margin, whole.x0), std::max(box.y0 - y_margin, whole.y0),
          std::min(box.x1 + x_margin, whole.x1), std::min(box.y1 + y_margin, whole.y1)};
}

bool is_empty(const Box& box) { return box.x0 > box.x1 || box.y0 > box.y1; }

Sides divide_at_value(const Fragment& f, const Entry& entry, const CellCut& cut) {
  Sides sides = divide_run({}, entry, cut);
  if (!sides.left || !sides.right) return sides;
  const bool x = cut.kind == CutKind::at_x;
  const double from = x ? f.p.x : f.p.y, to = x ? f.q.x : f.q.y;
  if (from == to) return sides;
  const double t = (cut.at - from) / (to - from);
  const double error = 4 * epsilon * (1 + (std::fabs(from) + std::fabs(cut.at)) / std::fabs(to - from)) +
                       entry.margin() / std::fabs(to - from);
  const bool p_left = from < to;
  (p_left ? sides.left_part.box : sides.right_part.box) = part_of(f, 0, t + error, entry);
  (p_left ? sides.right_part.box : sides.left_part.box) = part_of(f, t - error, 1, entry);
  return sides;
}

Sides divide_along_edge(std::span<const Point> points, const Fragment& f, const Entry& entry, const CellCut& cut) {
  Sides sides{true, true, entry, entry};
  const Point &a = points[cut.edge], &b = points[cut.edge + 1];
  const Point &c = points[entry.first], &d = points[entry.first + 1];
  const int c_side = exact::orientation(a, b, c), d_side = exact::orientation(a, b, d);
  if (c_side == 0 && d_side == 0) return sides;
  // An edge that only touches the line stays on one side, if it does so on the cut's own edge: whatever it
  // meets there, that edge meets too, and it is on both sides.
  const Box own = Box::of(a, b);
  const auto touches_elsewhere = [&](int side, const Point& p) { return side == 0 && !own.contains(p); };
  const auto touches_here = [&](int side, const Point& p) { return side == 0 && entry.box.contains(p); };
  const bool touches = touches_here(c_side, c) || touches_here(d_side, d);
  if (!touches_elsewhere(c_side, c) && !touches_elsewhere(d_side, d) &&
      (entry.margin() == 0 || (touches && cut.parts_touching))) {
    if (c_side >= 0 && d_side >= 0) sides.right = false;
    if (c_side <= 0 && d_side <= 0) sides.left = false;
    sides.touches = touches && !(sides.left && sides.right);
    if (!sides.left || !sides.right) return sides;
  }

  const double dx = b.x - a.x, dy = b.y - a.y;
  const auto distance = [&](const Point& p) { return dx * (p.y - a.y) - dy * (p.x - a.x); };
  const auto error_at = [&](const Point& p) {
    return 8 * epsilon *
           (std::fabs(dx) * (std::fabs(p.y) + std::fabs(a.y)) + std::fabs(dy) * (std::fabs(p.x) + std::fabs(a.x)));
  };
  // Doubled areas over (a, b), as the margin's strip is: at least its width times the length.
  const double strip = entry.margin() * (std::fabs(dx) + std::fabs(dy));
  const double p = distance(f.p), q = distance(f.q), error = std::max(error_at(f.p), error_at(f.q)) + strip;
  if (p > error && q > error) sides.right = false;
  if (p < -error && q < -error) sides.left = false;
  if (!sides.left || !sides.right || std::fabs(p - q) <= 4 * error) return sides;
  const double t = p / (p - q), t_error = 4 * error / std::fabs(p - q) + 4 * epsilon;
  (p > q ? sides.left_part.box : sides.right_part.box) = part_of(f, 0, t + t_error, entry);
  (p > q ? sides.right_part.box : sides.left_part.box) = part_of(f, t - t_error, 1, entry);
  sides.left = !is_empty(sides.left_part.box);
  sides.right = !is_empty(sides.right_part.box);
  return sides;
}

/// Judges a cut on the sample. `repeated` says how many edges of an entry will be on both sides if the entry is.
template <class Divide, class Repeated>
void judge(CellCut& cut, std::span<const Entry* const> sample, const Divide& divide, const Repeated& repeated) {
  std::size_t left = 0, right = 0;
  std::uint32_t edges = 0, twice = 0;
  for (const Entry* e : sample) {
    const Sides sides = divide(*e, cut);
    left += sides.left;
    right += sides.right;
    edges += e->last - e->first;
    if (sides.left && sides.right) twice += repeated(*e, cut);
  }
  const std::size_t most = sample.size() * 7 / 8;
  if (left <= most && right <= most) cut.growth = 1 + static_cast<double>(twice) / static_cast<double>(edges);
}

/// Entries drawn at random, the same ones each time: evenly spaced ones would follow the input's own rhythm.
class Sample {
 public:
  explicit Sample(std::span<const Entry> entries) {
    std::uint64_t state = entries.size();
    for (const Entry*& e : sample_) {
      state = mix(state + 0x9e3779b97f4a7c15ULL);
      e = &entries[((state >> 32) * entries.size()) >> 32];
    }
  }
  std::span<const Entry* const> span() const { return sample_; }

  /// The median of the middles, which moves out of the boxes' own ends where it can.
  CellCut median_cut(CutKind kind) const {
    double middles[sample_size];
    for (std::size_t i = 0; i < sample_size; ++i)
      middles[i] = low(sample_[i]->box, kind) / 2 + high(sample_[i]->box, kind) / 2;
    std::nth_element(middles, middles + sample_size / 2, middles + sample_size);
    return {kind, middles[sample_size / 2]};
  }

 private:
  const Entry* sample_[sample_size];
};

template <class Repeated>
CellCut best_axis_cut(const Sample& sample, const Repeated& repeated) {
  CellCut best;
  for (const CutKind kind : {CutKind::at_x, CutKind::at_y}) {
    CellCut cut = sample.median_cut(kind);
    judge(
        cut, sample.span(), [](const Entry& e, const CellCut& c) { return divide_run({}, e, c); }, repeated);
    if (cut.growth < best.growth) best = cut;
  }
  return best;
}

}  // namespace

Sides divide_run(std::span<const Point> points, const Entry& entry, const CellCut& cut) {
  Sides sides{reaches_left(low(entry.box, cut.kind), cut), reaches_right(high(entry.box, cut.kind), cut), entry, entry};
  if (!sides.left || !sides.right || entry.last - entry.first < tuning::shortest_divided_run || points.empty())
    return sides;
  const auto value = [&](std::uint32_t vertex) {
    return cut.kind == CutKind::at_x ? points[vertex].x : points[vertex].y;
  };
  const bool rising = value(entry.first) <= value(entry.last);
  const double margin = entry.margin();
  const auto left = [&](double v) { return reaches_left(v - margin, cut); };
  const auto right = [&](double v) { return reaches_right(v + margin, cut); };
  const auto reaches_start = [&](double v) { return rising ? left(v) : right(v); };
  const auto reaches_end = [&](double v) { return rising ? right(v) : left(v); };
  Entry &start = rising ? sides.left_part : sides.right_part, &end = rising ? sides.right_part : sides.left_part;
  while (!reaches_end(value(end.first + 1))) ++end.first;
  start.last = end.first + 1;
  while (start.last < entry.last && reaches_start(value(start.last))) ++start.last;
  start.box = Box::of(points[start.first], points[start.last]).widened(margin);
  end.box = Box::of(points[end.first], points[end.last]).widened(margin);
  return sides;
}

std::size_t divide_runs(std::span<const Point> points, LargeArray<Entry>& entries, std::size_t begin,
                        const CellCut& cut, LargeArray<Entry>& right) {
  // Where a run lies is hard to foresee, so a block of them is sorted out first, without branches.
  constexpr std::size_t block = tuning::divided_runs_a_block;
  std::array<std::uint8_t, block> on_left, on_right_only;
  std::size_t left_end = begin;
  for (std::size_t first = begin, size; first < entries.size(); first += size) {
    size = std::min(block, entries.size() - first);
    std::size_t lefts = 0, rights = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const bool left = reaches_left(low(entries[first + i].box, cut.kind), cut);
      on_left[lefts] = on_right_only[rights] = static_cast<std::uint8_t>(i);
      lefts += left;
      rights += !left;
    }
    for (std::size_t i = 0; i < rights; ++i) right.push_back(entries[first + on_right_only[i]]);
    for (std::size_t i = 0; i < lefts; ++i) {
      const Entry e = entries[first + on_left[i]];
      if (!reaches_right(high(e.box, cut.kind), cut)) {
        entries[left_end++] = e;
        continue;
      }
      const Sides sides = divide_run(points, e, cut);
      entries[left_end++] = sides.left_part;
      right.push_back(sides.right_part);
    }
  }
  return left_end;
}

Sides divide_edge(std::span<const Point> points, const Entry& entry, const CellCut& cut) {
  const Fragment f = fragment_of(points, entry);
  if (cut.kind == CutKind::along_edge) return divide_along_edge(points, f, entry, cut);
  return divide_at_value(f, entry, cut);
}

bool is_flat(const Entry& entry, Axis axis, const Box& cell, std::size_t count) {
  const Axis across = axis == Axis::x ? Axis::y : Axis::x;
  return (high(entry.box, across) - low(entry.box, across)) * static_cast<double>(count) <=
         high(cell, across) - low(cell, across);
}

CellCut best_run_cut(std::span<const Entry> entries, RunParts parts) {
  return best_axis_cut(Sample(entries), [&](const Entry& run, const CellCut&) {
    // To look where a run is divided would cost more than it tells: within one edge.
    return parts == RunParts::edges ? 1 : run.last - run.first;
  });
}

CellCut best_cut(std::span<const Point> points, std::span<const Entry> entries, const Box& cell, bool may_part) {
  const auto divide = [&](const Entry& e, const CellCut& c) { return divide_edge(points, e, c); };
  const Sample sample(entries);
  // Flat edges are copied until they cross a cell, which is soon.
  CellCut best = best_axis_cut(sample, [&](const Entry& e, const CellCut& cut) {
    return is_flat(e, axis_of(cut.kind), cell, entries.size()) ? 0U : 1U;
  });
  const auto try_edges = [&](bool parts_touching) {
    for (std::size_t i = 0; i < sample_size; ++i) {
      if (best.growth <= tuning::good_growth ||
          (i >= tuning::cut_edges_tried && best.growth <= tuning::acceptable_growth))
        break;
      CellCut cut{CutKind::along_edge, 0, sample.span()[i]->first, parts_touching};
      judge(cut, sample.span(), divide, [](const Entry&, const CellCut&) { return 1U; });
      if (cut.growth < best.growth) best = cut;
    }
  };
  const bool have_margins =
      std::any_of(sample.span().begin(), sample.span().end(), [](const Entry* e) { return e->margin() > 0; });
  if (have_margins) try_edges(false);
  if (!have_margins || (may_part && best.growth > tuning::growth_worth_parting)) try_edges(true);
  return best;
}

}  // namespace oblast::internal::noding
