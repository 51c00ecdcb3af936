// The exact arrangement of contours, cut into trapezoids.
#include "verify/slabs.h"

#include <algorithm>

namespace oblast::verify {
namespace {

struct Segment {
  Point low, high;  // lexicographically; not vertical
  std::size_t operand;
  std::size_t polygon;
  int winding;  // change of the winding number when it is stepped over from below to above
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
          if (from.x < to.x) segments.push_back({from, to, o, p, 1});
          if (from.x > to.x) segments.push_back({to, from, o, p, -1});
        }
      }
    }
  }
  return segments;
}

std::vector<Rational> abscissae_of(const std::vector<Segment>& segments) {
  std::vector<Rational> xs;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    xs.emplace_back(s.low.x);
    xs.emplace_back(s.high.x);
    for (std::size_t j = 0; j < i; ++j) {
      const Segment& t = segments[j];
      if (s.high.x <= t.low.x || t.high.x <= s.low.x) continue;
      if (std::max(s.low.y, s.high.y) < std::min(t.low.y, t.high.y)) continue;
      if (std::max(t.low.y, t.high.y) < std::min(s.low.y, s.high.y)) continue;
      if (const auto crossing = intersection_of_segments(s.low, s.high, t.low, t.high)) xs.push_back(crossing->x);
    }
  }
  std::sort(xs.begin(), xs.end());
  xs.erase(std::unique(xs.begin(), xs.end()), xs.end());
  return xs;
}

// Where one is, on the way up through a slab, relative to one operand.
class Inside {
 public:
  explicit Inside(const Operand& operand) : rule_(operand.rule), odd_(operand.regions.polygon_count(), false) {}

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
  std::vector<bool> odd_;  // by polygon: is its even-odd rule inside here?
  int covering_ = 0;       // how many polygons are
};

Rational height_at(const Segment& s, const Rational& x) {
  const Rational x0(s.low.x), y0(s.low.y);
  if (s.low.y == s.high.y) return y0;
  return y0 + (x - x0) * (Rational(s.high.y) - y0) / (Rational(s.high.x) - x0);
}

}  // namespace

void for_each_trapezoid(const std::vector<Operand>& operands, const std::function<void(const Trapezoid&)>& visit) {
  const std::vector<Segment> segments = segments_of(operands);
  const std::vector<Rational> xs = abscissae_of(segments);
  struct Crossed {
    Rational y;
    const Segment* segment;
  };
  std::vector<Crossed> column;
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    const Rational width = xs[i + 1] - xs[i];
    const Rational middle = (xs[i] + xs[i + 1]) / 2;
    column.clear();
    for (const Segment& s : segments) {
      if (Rational(s.low.x) <= xs[i] && xs[i + 1] <= Rational(s.high.x)) column.push_back({height_at(s, middle), &s});
    }
    std::sort(column.begin(), column.end(), [](const Crossed& c, const Crossed& d) { return c.y < d.y; });
    std::vector<Inside> inside(operands.begin(), operands.end());
    for (std::size_t c = 0; c + 1 < column.size(); ++c) {
      inside[column[c].segment->operand].step_over(*column[c].segment);
      if (column[c].y == column[c + 1].y) continue;
      // The height in the middle is the mean height, so this is the trapezoid's area.
      Trapezoid trapezoid{{middle, (column[c].y + column[c + 1].y) / 2}, width * (column[c + 1].y - column[c].y), {}};
      for (const Inside& operand : inside) trapezoid.inside.push_back(operand.value());
      visit(trapezoid);
    }
  }
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
    if (selects(operation, t.inside[0], t.inside[1])) area += t.area;
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
