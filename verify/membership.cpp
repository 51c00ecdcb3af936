// The fill rules, for one step at a time.
#include "verify/membership.h"

#include <algorithm>

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

// With a rule on winding numbers, each uncertain edge may add its change. With a rule on polygons, a polygon with one
// uncertain edge either covers the place or not. With two or more, its edges may have changed places, and the polygon
// may wind around a sliver between them twice or in the wrong direction. Each edge changes the count by at most one.
MayBe Membership::Side::may_be_inside(std::span<UncertainEdge> edges) const {
  std::int64_t low = rule.by_polygon() ? covering : winding, high = low;
  if (!rule.by_polygon()) {
    for (const UncertainEdge& e : edges) (e.side > 0 ? --low : ++high);
    return by_number(low, high);
  }
  const auto by_polygon = [](const UncertainEdge& e, const UncertainEdge& f) {
    return e.segment->polygon < f.segment->polygon;
  };
  std::sort(edges.begin(), edges.end(), by_polygon);
  for (auto first = edges.begin(); first != edges.end();) {
    const auto last = std::upper_bound(first, edges.end(), *first, by_polygon);
    const std::int64_t count = last - first;
    const bool here = odd[first->segment->polygon] != 0;
    if (count > 1 || here) low -= count;
    if (count > 1 || !here) high += count;
    first = last;
  }
  return by_number(low, high);
}

// Whether the numbers from low to high may mean inside, and whether they may mean outside.
MayBe Membership::Side::by_number(std::int64_t low, std::int64_t high) const {
  switch (rule.kind) {
    case FillRule::Kind::polygons:
      return {high > 0, low <= 0};
    case FillRule::Kind::at_least:
      return {high >= rule.depth, low < rule.depth};
    case FillRule::Kind::even_odd:
      return {low != high || low % 2 != 0, low != high || low % 2 == 0};
    case FillRule::Kind::nonzero:
      return {low != 0 || high != 0, low <= 0 && high >= 0};
    case FillRule::Kind::positive:
      return {high > 0, low <= 0};
    case FillRule::Kind::negative:
      return {low < 0, high >= 0};
  }
  return {true, true};
}

}  // namespace oblast::verify
