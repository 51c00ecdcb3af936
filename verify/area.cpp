// Edges are listed by bands of y. A place that is known by an estimate only may belong to the band beside, so edges are
// listed there, too, and bands are much higher than the error of estimates.
#include "verify/area.h"

#include "verify/predicates.h"

namespace oblast::verify {
namespace {

int sign(const Estimate& e) { return e.certainly_positive() ? 1 : -e.value > e.error ? -1 : 0; }

/// The sign of p.y - y.
int compare_y(const Location& p, double y) {
  const Estimate difference = p.estimate().y - Estimate(y);
  if (const int found = sign(difference)) return found;
  if (p.is_double()) {
    const double own = p.rounded().y;
    return (own > y) - (own < y);
  }
  return p.exact().y.compare(Rational(y));
}

}  // namespace

Location::Location(const RationalPoint& p) {
  const auto estimated = [](const Rational& value) {
    const double rounded = round_to_nearest(value);
    return Estimate(rounded, std::abs(rounded) * 0x1p-52L);
  };
  estimate_ = {estimated(p.x), estimated(p.y)};
  exact_ = p;
  const Point rounded_ = rounded();
  is_double_ = p.x == Rational(rounded_.x) && p.y == Rational(rounded_.y);
  if (is_double_) estimate_ = EstimatedPoint(rounded_);
}

Location::Location(const Location& p, const Location& q) : first_(p.rounded()), second_(q.rounded()) {
  const auto middle = [](const Estimate& a, const Estimate& b) { return (a + b) * Estimate(0.5); };
  estimate_ = {middle(p.estimate_.x, q.estimate_.x), middle(p.estimate_.y, q.estimate_.y)};
  if (p.is_double() && q.is_double()) return;
  exact_ = RationalPoint((p.exact().x + q.exact().x) / 2, (p.exact().y + q.exact().y) / 2);
}

const RationalPoint& Location::exact() const {
  if (!exact_) {
    const RationalPoint p(first_), q(second_);
    exact_ = RationalPoint((p.x + q.x) / 2, (p.y + q.y) / 2);
  }
  return *exact_;
}

Box Location::box() const {
  const auto down = [](long double v) { return std::nextafter(static_cast<double>(v), -HUGE_VAL); };
  const auto up = [](long double v) { return std::nextafter(static_cast<double>(v), HUGE_VAL); };
  return {Point{down(estimate_.x.least()), down(estimate_.y.least())},
          Point{up(estimate_.x.most()), up(estimate_.y.most())}};
}

int side_of_line(const Point& a, const Point& b, const Location& p) {
  if (p.is_double()) return side_of_line(a, b, p.rounded());
  const Estimate determinant = (Estimate(b.x) - Estimate(a.x)) * (p.estimate().y - Estimate(a.y)) -
                               (Estimate(b.y) - Estimate(a.y)) * (p.estimate().x - Estimate(a.x));
  if (const int found = sign(determinant)) return found;
  const RationalPoint from(a), to(b), &at = p.exact();
  const Rational exact = (to.x - from.x) * (at.y - from.y) - (to.y - from.y) * (at.x - from.x);
  return exact.sign();
}

Area::Area(std::vector<Stroke> edges) : edges_(std::move(edges)) {
  for (const Stroke& e : edges_) box_.add(e.box());
  if (edges_.empty()) return;
  const double height = box_.high.y - box_.low.y, largest = std::max(std::abs(box_.low.y), std::abs(box_.high.y));
  const double finest = largest > 0 ? height / (largest * 0x1p-46) : 0;
  bands_ = static_cast<std::size_t>(std::clamp(finest, 1.0, static_cast<double>(edges_.size())));
  for (;; bands_ = (bands_ + 1) / 2) {
    per_band_ = bands_ > 1 ? static_cast<double>(bands_) / height : 0;
    std::size_t listed = 0;
    for (const Stroke& e : edges_) listed += band_of(e.box().high.y) - band_of(e.box().low.y) + 3;
    if (bands_ == 1 || listed <= 16 * edges_.size()) break;
  }
  std::vector<std::vector<std::uint32_t>> lists(bands_);
  for (std::uint32_t e = 0; e < edges_.size(); ++e) {
    const std::size_t low = band_of(edges_[e].box().low.y), high = band_of(edges_[e].box().high.y);
    for (std::size_t band = low - (low > 0); band <= std::min(high + 1, bands_ - 1); ++band) lists[band].push_back(e);
  }
  for (const auto& list : lists) {
    in_band_.insert(in_band_.end(), list.begin(), list.end());
    band_ends_.push_back(static_cast<std::uint32_t>(in_band_.size()));
  }
}

std::size_t Area::band_of(double y) const {
  return static_cast<std::size_t>(std::clamp((y - box_.low.y) * per_band_, 0.0, static_cast<double>(bands_ - 1)));
}

std::span<const std::uint32_t> Area::edges_at(double y) const {
  if (edges_.empty()) return {};
  const std::size_t band = band_of(y), begin = band == 0 ? 0 : band_ends_[band - 1];
  return std::span(in_band_).subspan(begin, band_ends_[band] - begin);
}

Area::Where Area::where(const Point& p) const {
  if (!box_.meets(Box(p, p))) return Where::outside;
  bool inside = false;
  for (const std::uint32_t k : edges_at(p.y)) {
    const Stroke& e = edges_[k];
    if (!e.box().meets(Box({p.x, p.y}, {HUGE_VAL, p.y}))) continue;
    const int side = e.a.y <= e.b.y ? side_of_line(e.a, e.b, p) : side_of_line(e.b, e.a, p);
    if (side == 0 && e.box().meets(Box(p, p))) return Where::on;
    if ((e.a.y <= p.y) != (e.b.y <= p.y) && side > 0) inside = !inside;
  }
  return inside ? Where::inside : Where::outside;
}

// A ray goes east from the place, or from just below or just above it. An edge that the place is on is met by the ray
// that starts west of it, and not by the one that starts east.
Area::Sides Area::beside(const Location& p, bool on_horizontal) const {
  Sides sides;
  const Box at = p.box();
  if (!box_.meets(at)) return sides;
  for (const std::uint32_t k : edges_at(p.rounded().y)) {
    const Stroke& e = edges_[k];
    if (e.box().high.x < at.low.x || e.box().high.y < at.low.y || e.box().low.y > at.high.y) continue;
    const int a = compare_y(p, e.a.y), b = compare_y(p, e.b.y);
    const bool meets_below = (a > 0) != (b > 0), meets_above = (a >= 0) != (b >= 0);
    if (!meets_below && !meets_above) continue;
    const int side = e.a.y <= e.b.y ? side_of_line(e.a, e.b, p) : side_of_line(e.b, e.a, p);
    if (on_horizontal) {
      sides.first ^= meets_below && side > 0;
      sides.second ^= meets_above && side > 0;
    } else if (meets_above) {
      sides.first ^= side >= 0;
      sides.second ^= side > 0;
    }
  }
  return sides;
}

}  // namespace oblast::verify
