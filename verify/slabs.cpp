// The exact arrangement of contours, divided into trapezoids.
#include "verify/slabs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>

#include "verify/predicates.h"
#include "verify/scaled.h"

namespace oblast::verify {
namespace {

struct Segment {
  Point low, high;  // lexicographically; not vertical
  std::size_t operand;
  std::size_t polygon;
  int winding;                     // change of the winding number from below to above
  std::size_t begin = 0, end = 0;  // the slabs it spans: [begin, end)
};

std::vector<Segment> segments_of(const std::vector<Operand>& operands) {
  std::vector<Segment> segments;
  for (std::size_t o = 0; o < operands.size(); ++o) {
    const RegionView& regions = operands[o].regions;
    for (std::size_t p = 0; p < regions.polygon_count(); ++p) {
      for (std::size_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c) {
        const auto contour = regions.contour(c);
        for (std::size_t v = 0; v < contour.size(); ++v) {
          const Point from = contour[v], to = contour[(v + 1) % contour.size()];
          if (from.x < to.x) segments.push_back({from, to, o, p, 1, 0, 0});
          if (from.x > to.x) segments.push_back({to, from, o, p, -1, 0, 0});
        }
      }
    }
  }
  return segments;
}

// The position relative to one operand, on the way up through a slab.
class Inside {
 public:
  explicit Inside(const Operand& operand) : rule_(operand.rule), odd_(operand.regions.polygon_count(), false) {}

  void go_below_all() {
    winding_ = covering_ = 0;
    odd_.assign(odd_.size(), false);
  }

  void step_over(const Segment& s) {
    winding_ += s.winding;
    odd_[s.polygon] = !odd_[s.polygon];
    covering_ += odd_[s.polygon] ? 1 : -1;
  }

  bool value() const {
    switch (rule_.kind) {
      case FillRule::Kind::polygons:
        return covering_ > 0;
      case FillRule::Kind::at_least:
        return covering_ >= rule_.depth;
      case FillRule::Kind::even_odd:
        return winding_ % 2 != 0;
      case FillRule::Kind::nonzero:
        return winding_ != 0;
      case FillRule::Kind::positive:
        return winding_ > 0;
      case FillRule::Kind::negative:
        return winding_ < 0;
    }
    return false;
  }

 private:
  FillRule rule_;
  int winding_ = 0;
  std::vector<bool> odd_;  // by polygon: whether the position is inside by even-odd
  int covering_ = 0;       // number of polygons that cover the position
};

Rational height_at(const Segment& s, const Rational& x) {
  const Rational x0(s.low.x), y0(s.low.y);
  if (s.low.y == s.high.y) return y0;
  return y0 + (x - x0) * (Rational(s.high.y) - y0) / (Rational(s.high.x) - x0);
}

// Coordinates have at most 653 bits (scaled.h). So the x of a crossing is a fraction of at most 1962 and 1308 bits, and
// the products that compare two of them have at most 3270.
using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<3328, 3328, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;

struct Fraction {
  Wide numerator;
  Wide denominator;
};

// A value > 0, given by its first 64 bits, times 2 to the power of `shift`.
struct Leading {
  long double value;
  int shift;
};
Leading leading_bits(const Wide& positive) {
  const int shift = std::max(0, static_cast<int>(msb(positive)) - 63);
  return {static_cast<long double>(static_cast<std::uint64_t>(positive >> shift)), shift};
}

Estimate to_estimate(const Fraction& fraction, int exponent) {
  if (fraction.numerator.is_zero()) return 0.0;
  const Leading above = leading_bits(abs(fraction.numerator)), below = leading_bits(fraction.denominator);
  const long double size = std::ldexp(above.value / below.value, above.shift - below.shift + exponent);
  // The relative error of each of the two is less than 2^-63; the rest is rounding.
  return {fraction.numerator.sign() < 0 ? -size : size, 8 * std::numeric_limits<long double>::epsilon() * size};
}

std::vector<Point> ends_of(const std::vector<Segment>& segments) {
  std::vector<Point> ends;
  for (const Segment& s : segments) ends.insert(ends.end(), {s.low, s.high});
  return ends;
}

// The x coordinate of a vertex, or of a crossing of two segments.
struct Abscissa {
  Estimate estimate;
  const Segment* one = nullptr;  // null: a vertex, and the estimate has no error
  const Segment* other = nullptr;

  Rational exact() const {
    if (one == nullptr) return Rational(static_cast<double>(estimate.value));
    return intersection_of_segments(one->low, one->high, other->low, other->high)->x;
  }
};

}  // namespace

// The slabs between neighbouring abscissae, and the order of segments in them.
class Slabs {
 public:
  explicit Slabs(const std::vector<Operand>& operands)
      : operands_(operands), segments_(segments_of(operands)), scale_(ends_of(segments_)) {
    compare_all_pairs();
    sort_abscissae();
  }

  void visit_all(const std::function<void(const Trapezoid&)>& visit) {
    std::vector<Inside> inside(operands_.begin(), operands_.end());
    std::vector<std::size_t> column;
    for (std::size_t slab = 0; slab + 1 < abscissae_.size(); ++slab) {
      update(column, slab);
      for (Inside& operand : inside) operand.go_below_all();
      for (std::size_t c = 0; c + 1 < column.size(); ++c) {
        const Segment& low = segments_[column[c]];
        inside[low.operand].step_over(low);
        if (order(column[c], column[c + 1], slab) == 0) continue;
        Trapezoid trapezoid;
        for (const Inside& operand : inside) trapezoid.inside.push_back(operand.value());
        trapezoid.slabs_ = this;
        trapezoid.slab_ = slab;
        trapezoid.low_ = column[c];
        trapezoid.high_ = column[c + 1];
        visit(trapezoid);
      }
    }
  }

  Rational left(std::size_t slab) const { return abscissae_[slab].exact(); }
  Rational right(std::size_t slab) const { return abscissae_[slab + 1].exact(); }
  Rational height(std::size_t segment, const Rational& x) const { return height_at(segments_[segment], x); }

  Estimate estimated_left(std::size_t slab) const { return abscissae_[slab].estimate; }
  Estimate estimated_right(std::size_t slab) const { return abscissae_[slab + 1].estimate; }
  Estimate estimated_height(std::size_t segment, const Estimate& x) const {
    const Segment& s = segments_[segment];
    if (s.low.y == s.high.y) return s.low.y;
    const Estimate dx = Estimate(s.high.x) - Estimate(s.low.x), dy = Estimate(s.high.y) - Estimate(s.low.y);
    return Estimate(s.low.y) + (x - Estimate(s.low.x)) * dy / dx;
  }

 private:
  // Two segments over their common range of x: +1 if the second is above the first, -1 if it is below, 0 if they touch
  // or coincide. If the signs at the two ends differ, they cross, at abscissa `crossing`.
  struct Pair {
    std::int8_t at_begin = 0, at_end = 0;
    std::size_t crossing = 0;
  };

  // +1 if p lies above s.
  static int above(const Segment& s, const Point& p) { return side_of_line(s.low, s.high, p); }

  void compare_all_pairs() {
    pairs_.resize(segments_.size() * segments_.size());
    for (const Segment& s : segments_)
      abscissae_.insert(abscissae_.end(), {{s.low.x, nullptr, nullptr}, {s.high.x, nullptr, nullptr}});
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const Segment& s = segments_[i];
      for (std::size_t j = 0; j < i; ++j) {
        const Segment& t = segments_[j];
        if (s.high.x <= t.low.x || t.high.x <= s.low.x) continue;
        Pair& pair = pairs_[i * segments_.size() + j];
        pair.at_begin = static_cast<std::int8_t>(s.low.x < t.low.x ? above(s, t.low) : -above(t, s.low));
        pair.at_end = static_cast<std::int8_t>(t.high.x < s.high.x ? above(s, t.high) : -above(t, s.high));
        if (pair.at_begin * pair.at_end < 0)
          abscissae_.push_back({estimated_crossing(s.low, s.high, t.low, t.high).x, &s, &t});
      }
    }
  }

  // Also sets the slabs in which segments begin and end, and in which pairs cross.
  void sort_abscissae() {
    const std::vector<Abscissa> unsorted = std::move(abscissae_);
    std::vector<std::optional<Fraction>> fractions(unsorted.size());
    const auto exactly = [&](std::size_t i) -> const Fraction& {
      if (!fractions[i]) fractions[i] = fraction(unsorted[i]);
      return *fractions[i];
    };
    const auto less = [&](std::size_t i, std::size_t j) {
      const Abscissa &a = unsorted[i], &b = unsorted[j];
      if (a.one == nullptr && b.one == nullptr) return a.estimate.value < b.estimate.value;
      if (certainly_less(a.estimate, b.estimate)) return true;
      if (certainly_less(b.estimate, a.estimate)) return false;
      const Fraction &p = exactly(i), &q = exactly(j);
      return p.numerator * q.denominator < q.numerator * p.denominator;
    };
    std::vector<std::size_t> order(unsorted.size()), rank(unsorted.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), less);
    abscissae_.clear();
    for (std::size_t k = 0; k < order.size(); ++k) {
      if (k == 0 || less(order[k - 1], order[k])) abscissae_.push_back(unsorted[order[k]]);
      // Of equal abscissae it keeps a vertex, which has no error.
      if (unsorted[order[k]].one == nullptr) abscissae_.back() = unsorted[order[k]];
      rank[order[k]] = abscissae_.size() - 1;
    }
    // The first estimate of the crossing of nearly parallel edges is poor.
    for (Abscissa& a : abscissae_) {
      if (a.one != nullptr && !(a.estimate.error < std::abs(a.estimate.value) * 0x1p-58L))
        a.estimate = to_estimate(fraction(a), scale_.exponent());
    }
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      segments_[s].begin = rank[2 * s];
      segments_[s].end = rank[2 * s + 1];
    }
    for (std::size_t c = 2 * segments_.size(); c < unsorted.size(); ++c) {
      const auto i = static_cast<std::size_t>(unsorted[c].one - segments_.data());
      const auto j = static_cast<std::size_t>(unsorted[c].other - segments_.data());
      pairs_[i * segments_.size() + j].crossing = rank[c];
    }
  }

  // In units of the scale. Not reduced; the denominator is greater than 0.
  Fraction fraction(const Abscissa& abscissa) const {
    if (abscissa.one == nullptr) return {Wide(scale_({static_cast<double>(abscissa.estimate.value), 0}).x), 1};
    const ScaledPoint a = scale_(abscissa.one->low), b = scale_(abscissa.one->high);
    const ScaledPoint c = scale_(abscissa.other->low), d = scale_(abscissa.other->high);
    const Wide dx1(b.x - a.x), dy1(b.y - a.y), dx2(d.x - c.x), dy2(d.y - c.y), px(c.x - a.x), py(c.y - a.y);
    Wide denominator = dx1 * dy2 - dy1 * dx2;
    Wide numerator = Wide(a.x) * denominator + (px * dy2 - py * dx2) * dx1;
    if (denominator.sign() < 0) return {-numerator, -denominator};
    return {std::move(numerator), std::move(denominator)};
  }

  // +1 if segment t is above segment s in the slab, which both span; 0 if they coincide there.
  int order(std::size_t s, std::size_t t, std::size_t slab) const {
    if (s == t) return 0;
    if (s < t) return -order(t, s, slab);
    const Pair& pair = pairs_[s * segments_.size() + t];
    if (pair.at_begin == 0) return pair.at_end;
    if (pair.at_end == 0 || pair.at_begin == pair.at_end) return pair.at_begin;
    return pair.crossing <= slab ? pair.at_end : pair.at_begin;
  }

  // Updates the column from the slab before to this slab. Few segments change their places.
  void update(std::vector<std::size_t>& column, std::size_t slab) const {
    std::erase_if(column, [&](std::size_t s) { return segments_[s].end <= slab; });
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      if (segments_[s].begin == slab) column.push_back(s);
    }
    for (std::size_t c = 1; c < column.size(); ++c) {
      for (std::size_t d = c; d > 0 && order(column[d - 1], column[d], slab) < 0; --d)
        std::swap(column[d - 1], column[d]);
    }
  }

  const std::vector<Operand>& operands_;
  std::vector<Segment> segments_;
  Scale scale_;
  std::vector<Pair> pairs_;          // (s, t) with s > t at s n + t
  std::vector<Abscissa> abscissae_;  // sorted, all different
};

// The height in the middle of a slab is the mean height. So the product with the width is the area of the trapezoid.
Rational Trapezoid::area() const {
  const Rational left = slabs_->left(slab_), right = slabs_->right(slab_), middle = (left + right) / 2;
  return (right - left) * (slabs_->height(high_, middle) - slabs_->height(low_, middle));
}

RationalPoint Trapezoid::centre() const {
  const Rational middle = (slabs_->left(slab_) + slabs_->right(slab_)) / 2;
  return {middle, (slabs_->height(low_, middle) + slabs_->height(high_, middle)) / 2};
}

Estimate Trapezoid::estimated_area() const {
  const Estimate left = slabs_->estimated_left(slab_), right = slabs_->estimated_right(slab_);
  const Estimate middle = (left + right) * 0.5;
  return (right - left) * (slabs_->estimated_height(high_, middle) - slabs_->estimated_height(low_, middle));
}

EstimatedPoint Trapezoid::estimated_centre() const {
  const Estimate middle = (slabs_->estimated_left(slab_) + slabs_->estimated_right(slab_)) * 0.5;
  return {middle, (slabs_->estimated_height(low_, middle) + slabs_->estimated_height(high_, middle)) * 0.5};
}

void for_each_trapezoid(const std::vector<Operand>& operands, const std::function<void(const Trapezoid&)>& visit) {
  Slabs(operands).visit_all(visit);
}

bool selects(Operation operation, bool inside_a, bool inside_b) {
  switch (operation) {
    case Operation::intersection:
      return inside_a && inside_b;
    case Operation::unite:
      return inside_a || inside_b;
    case Operation::difference:
      return inside_a && !inside_b;
    case Operation::symmetric_difference:
      return inside_a != inside_b;
  }
  return false;
}

Rational exact_area(const Operand& a, const Operand& b, Operation operation) {
  Rational area = 0;
  for_each_trapezoid({a, b}, [&](const Trapezoid& t) {
    if (selects(operation, t.inside[0], t.inside[1])) area += t.area();
  });
  return area;
}

Rational exact_signed_area(const RegionView& regions) {
  Rational twice = 0;
  for (std::size_t c = 0; c < regions.contour_count(); ++c) {
    const auto contour = regions.contour(c);
    for (std::size_t v = 0; v < contour.size(); ++v) {
      const RationalPoint p(contour[v]), q(contour[(v + 1) % contour.size()]);
      twice += p.x * q.y - q.x * p.y;
    }
  }
  return twice / 2;
}

}  // namespace oblast::verify
