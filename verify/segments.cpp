// Tests of edges and points: doubles if they certainly decide, otherwise more bits.
#include "verify/segments.h"

#include <oblast/domain.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <stdexcept>

#include "verify/predicates.h"

namespace oblast::verify {
namespace {

// 113 bits. Differences of coordinates may be rounded, but with a relative error below 2^-112.
using Quad = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_quad::backend_type,
                                           boost::multiprecision::et_off>;

}  // namespace

void Box::include(const Point& p) {
  x0 = std::min(x0, p.x);
  y0 = std::min(y0, p.y);
  x1 = std::max(x1, p.x);
  y1 = std::max(y1, p.y);
}

Segments::Segments(const RegionView& a, const RegionView& b, const RegionView& result) {
  const std::size_t most = a.points.size() + b.points.size() + result.points.size();
  if (most >= 0xffffffff) throw std::length_error("more than 2^32 edges");
  all_.reserve(most);
  collect(a, EdgeOf::a);
  collect(b, EdgeOf::b);
  input_count_ = size();
  double largest = 0;
  for (const Segment& s : all_) largest = std::max({largest, std::abs(s.from.x), std::abs(s.from.y)});
  if (input_count_ > 0) unit_ = std::max(std::nextafter(largest, HUGE_VAL) - largest, domain_smallest);
  collect(result, EdgeOf::result);
  if (all_.empty()) return;
  box_ = {all_[0].from.x, all_[0].from.y, all_[0].from.x, all_[0].from.y};
  for (const Segment& s : all_) box_.include(s.from);
}

void Segments::collect(const RegionView& regions, EdgeOf owner) {
  for (std::uint32_t p = 0; p < regions.polygon_count(); ++p) {
    for (std::size_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c) {
      const auto contour = regions.contour(c);
      for (std::size_t v = 0; v < contour.size(); ++v) {
        const Point &from = contour[v], &to = contour[v + 1 == contour.size() ? 0 : v + 1];
        if (from != to) all_.push_back({from, to, p, owner});
      }
    }
  }
}

double rounding_along(const Segments& segments) {
  if (segments.size() == 0) return 0;
  const Box& box = segments.box();
  const double largest = std::max({std::abs(box.x0), std::abs(box.x1), std::abs(box.y0), std::abs(box.y1)});
  return 16 * std::max(std::nextafter(largest, HUGE_VAL) - largest, segments.unit());
}

// False if the line is further from the centre of the box than any corner (measured across the line) plus the margin
// and the rounding error of the determinant.
bool may_reach(const Segment& s, const Box& box, double margin) {
  if (std::max(s.from.x, s.to.x) < box.x0 - margin || std::min(s.from.x, s.to.x) > box.x1 + margin ||
      std::max(s.from.y, s.to.y) < box.y0 - margin || std::min(s.from.y, s.to.y) > box.y1 + margin) {
    return false;
  }
  const double dx = s.to.x - s.from.x, dy = s.to.y - s.from.y;
  const double x = box.x0 / 2 + box.x1 / 2, y = box.y0 / 2 + box.y1 / 2;
  const double left = dx * (y - s.from.y), right = dy * (x - s.from.x);
  const double reach = std::abs(dx) * ((box.y1 - box.y0) / 2 + 2 * margin) +
                       std::abs(dy) * ((box.x1 - box.x0) / 2 + 2 * margin) +
                       0x1p-48 * (std::abs(left) + std::abs(right));
  return std::abs(left - right) <= reach * (1 + 0x1p-48);
}

int side_of(const Segment& s, const Point& q) {
  const int side = side_of_line(s.from, s.to, q);
  if (side != 0) return side;
  if (s.from.y != s.to.y) return s.to.y > s.from.y ? 1 : -1;  // q' lies to the left of q
  return s.to.x > s.from.x ? 1 : -1;                          // and above it
}

bool in_box_of(const Segment& s, const Point& p) {
  return std::min(s.from.x, s.to.x) <= p.x && p.x <= std::max(s.from.x, s.to.x) && std::min(s.from.y, s.to.y) <= p.y &&
         p.y <= std::max(s.from.y, s.to.y);
}

bool lies_on(const Segment& s, const Point& p) {
  return in_box_of(s, p) && (p == s.from || p == s.to || side_of_line(s.from, s.to, p) == 0);
}

// In the box of a segment, the foot of p on its line lies between the ends.
double distance_in_box(const Segment& s, const Point& p) {
  const Quad dx = Quad(s.to.x) - Quad(s.from.x), dy = Quad(s.to.y) - Quad(s.from.y);
  const Quad across = dx * (Quad(p.y) - Quad(s.from.y)) - dy * (Quad(p.x) - Quad(s.from.x));
  return static_cast<double>(abs(across) / sqrt(dx * dx + dy * dy));
}

bool may_be_near(const Segment& s, const Point& p, double bound) {
  if (!in_box_of(s, p)) return false;
  // Doubles first, with an error bound as that of side_of_line. |dx| + |dy| is at least the length.
  const double dx = s.to.x - s.from.x, dy = s.to.y - s.from.y;
  const double left = dx * (p.y - s.from.y), right = dy * (p.x - s.from.x);
  const double slack = 0x1p-49 * (std::abs(left) + std::abs(right)) + bound * (std::abs(dx) + std::abs(dy));
  if (std::abs(left - right) > slack * (1 + 0x1p-48)) return false;
  return distance_in_box(s, p) <= bound * (1 + 0x1p-48);
}

}  // namespace oblast::verify
