// Edges are listed by bands of y. A place that is known by an estimate only may belong to the band beside, so edges are
// listed there, too, and bands are much higher than the error of estimates.
#include "verify/area.h"

#include <cmath>

#include "verify/predicates.h"

namespace oblast::verify {
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
