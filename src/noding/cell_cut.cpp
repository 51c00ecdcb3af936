#include "noding/cell_cut.h"

#include <algorithm>
#include <cmath>

#include "exact/orientation.h"
#include "noding/point_hash.h"

namespace oblast::noding {
namespace {

constexpr std::size_t sample_size = 31;
constexpr std::size_t edges_tried = 5;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

double low(const Box& box, CutKind kind) { return kind == CutKind::at_x ? box.x0 : box.y0; }
double high(const Box& box, CutKind kind) { return kind == CutKind::at_x ? box.x1 : box.y1; }

/// The clipped edge runs along a diagonal of its box.
struct Fragment {
  Point p, q;
};

Fragment fragment_of(std::span<const Point> points, const Entry& e) {
  const Point &a = points[e.first], &b = points[e.first + 1];
  const bool rising = (a.x < b.x) == (a.y < b.y);
  if (rising) return {{e.box.x0, e.box.y0}, {e.box.x1, e.box.y1}};
  return {{e.box.x0, e.box.y1}, {e.box.x1, e.box.y0}};
}

/// The box of the fragment's part between parameters s and t, widened by the rounding of its computation and kept
/// inside the box there was.
Box part_of(const Fragment& f, double s, double t, const Box& whole) {
  s = std::clamp(s, 0.0, 1.0);
  t = std::clamp(t, 0.0, 1.0);
  const auto at = [&](double u) { return Point{f.p.x + (f.q.x - f.p.x) * u, f.p.y + (f.q.y - f.p.y) * u}; };
  Box box = Box::of(at(s), at(t));
  const double x_margin = 4 * epsilon * (std::fabs(f.p.x) + std::fabs(f.q.x));
  const double y_margin = 4 * epsilon * (std::fabs(f.p.y) + std::fabs(f.q.y));
  return {std::max(box.x0 - x_margin, whole.x0), std::max(box.y0 - y_margin, whole.y0),
          std::min(box.x1 + x_margin, whole.x1), std::min(box.y1 + y_margin, whole.y1)};
}

Sides divide_at_value(const Fragment& f, const Entry& entry, const CellCut& cut) {
  Sides sides = divide_box(entry, cut);
  if (!sides.left || !sides.right) return sides;
  const bool x = cut.kind == CutKind::at_x;
  const double from = x ? f.p.x : f.p.y, to = x ? f.q.x : f.q.y;
  if (from == to) return sides;
  const double t = (cut.at - from) / (to - from);
  const double error = 4 * epsilon * (1 + (std::fabs(from) + std::fabs(cut.at)) / std::fabs(to - from)) +
                       cut.margin / std::fabs(to - from);
  const bool p_left = from < to;
  (p_left ? sides.left_box : sides.right_box) = part_of(f, 0, t + error, entry.box);
  (p_left ? sides.right_box : sides.left_box) = part_of(f, t - error, 1, entry.box);
  return sides;
}

Sides divide_along_edge(std::span<const Point> points, const Fragment& f, const Entry& entry, const CellCut& cut) {
  Sides sides{true, true, entry.box, entry.box};
  const Point &a = points[cut.edge], &b = points[cut.edge + 1];
  const Point &c = points[entry.first], &d = points[entry.first + 1];
  const int c_side = exact::orientation(a, b, c), d_side = exact::orientation(a, b, d);
  if (c_side == 0 && d_side == 0) return sides;
  // An edge that only touches the line stays on one side, if it does so on the cut's own edge: whatever it
  // meets there, that edge meets too, and it is on both sides.
  const Box own = Box::of(a, b);
  const auto touches_elsewhere = [&](int side, const Point& p) { return side == 0 && !own.meets(Box::of(p, p)); };
  const auto touches_here = [&](int side, const Point& p) { return side == 0 && entry.box.meets(Box::of(p, p)); };
  const bool touches = touches_here(c_side, c) || touches_here(d_side, d);
  if (!touches_elsewhere(c_side, c) && !touches_elsewhere(d_side, d) &&
      (cut.margin == 0 || (touches && cut.parts_touching))) {
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
  const double strip = cut.margin * (std::fabs(dx) + std::fabs(dy));
  const double p = distance(f.p), q = distance(f.q), error = std::max(error_at(f.p), error_at(f.q)) + strip;
  if (p > error && q > error) sides.right = false;
  if (p < -error && q < -error) sides.left = false;
  if (!sides.left || !sides.right || std::fabs(p - q) <= 4 * error) return sides;
  const double t = p / (p - q), t_error = 4 * error / std::fabs(p - q) + 4 * epsilon;
  (p > q ? sides.left_box : sides.right_box) = part_of(f, 0, t + t_error, entry.box);
  (p > q ? sides.right_box : sides.left_box) = part_of(f, t - t_error, 1, entry.box);
  return sides;
}

/// Judges a cut on the sample.
template <class Divide>
void judge(CellCut& cut, std::span<const Entry* const> sample, const Divide& divide) {
  std::size_t left = 0, right = 0;
  for (const Entry* e : sample) {
    const Sides sides = divide(*e, cut);
    left += sides.left;
    right += sides.right;
  }
  const std::size_t most = sample.size() * 7 / 8;
  if (left <= most && right <= most)
    cut.growth = static_cast<double>(left + right) / static_cast<double>(sample.size());
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

}  // namespace

Sides divide_box(const Entry& entry, const CellCut& cut) {
  return {low(entry.box, cut.kind) - cut.margin < cut.at, high(entry.box, cut.kind) + cut.margin >= cut.at, entry.box,
          entry.box};
}

Sides divide_edge(std::span<const Point> points, const Entry& entry, const CellCut& cut) {
  const Fragment f = fragment_of(points, entry);
  if (cut.kind == CutKind::along_edge) return divide_along_edge(points, f, entry, cut);
  return divide_at_value(f, entry, cut);
}

CellCut best_axis_cut(std::span<const Entry> entries, double margin) {
  const Sample sample(entries);
  CellCut best;
  for (const CutKind kind : {CutKind::at_x, CutKind::at_y}) {
    CellCut cut = sample.median_cut(kind);
    cut.margin = margin;
    judge(cut, sample.span(), divide_box);
    if (cut.growth < best.growth) best = cut;
  }
  return best;
}

CellCut best_cut(std::span<const Point> points, std::span<const Entry> entries, double margin) {
  const auto divide = [&](const Entry& e, const CellCut& c) { return divide_edge(points, e, c); };
  const Sample sample(entries);
  CellCut best = best_axis_cut(entries, margin);
  constexpr double good = 1.15, worth_parting = 1.3, acceptable = 1.5;
  const auto try_edges = [&](bool parts_touching) {
    for (std::size_t i = 0; i < sample_size; ++i) {
      if (best.growth <= good || (i >= edges_tried && best.growth <= acceptable)) break;
      CellCut cut{CutKind::along_edge, 0, sample.span()[i]->first, margin, parts_touching};
      judge(cut, sample.span(), divide);
      if (cut.growth < best.growth) best = cut;
    }
  };
  if (margin > 0) try_edges(false);
  if (margin == 0 || best.growth > worth_parting) try_edges(true);
  return best;
}

}  // namespace oblast::noding
