// The fill rules, one step at a time.
#include "verify/membership.h"

namespace oblast::verify {

Membership::Membership(const FillRule& a, std::size_t polygons_a, const FillRule& b, std::size_t polygons_b)
    : a_{a, std::vector<std::uint8_t>(a.by_polygon() ? polygons_a : 0)},
      b_{b, std::vector<std::uint8_t>(b.by_polygon() ? polygons_b : 0)} {}

void Membership::step_over(const Segment& s, int side) {
  switch (s.owner) {
    case EdgeOf::a:
      a_.step_over(s, side);
      break;
    case EdgeOf::b:
      b_.step_over(s, side);
      break;
    case EdgeOf::result:
      result_winding_ += side;
      break;
  }
}

void Membership::Side::step_over(const Segment& s, int side) {
  if (!rule.by_polygon()) {
    winding += side;
    return;
  }
  std::uint8_t& inside_polygon = odd[s.polygon];
  inside_polygon ^= 1;
  covering += inside_polygon != 0 ? 1 : -1;
}

bool Membership::Side::inside() const {
  switch (rule.kind) {
    case FillRule::Kind::polygons:
      return covering > 0;
    case FillRule::Kind::at_least:
      return covering >= rule.depth;
    case FillRule::Kind::even_odd:
      return winding % 2 != 0;
    case FillRule::Kind::nonzero:
      return winding != 0;
    case FillRule::Kind::positive:
      return winding > 0;
    case FillRule::Kind::negative:
      return winding < 0;
  }
  return false;
}

}  // namespace oblast::verify
