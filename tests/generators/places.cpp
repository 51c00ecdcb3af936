// Places cases side by side.
#include <oblast/domain.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "generators/crowd.h"

namespace oblast::generators {
namespace {

double into_domain(double c) {
  if (std::abs(c) < domain_smallest) return 0.0;
  return std::clamp(c, -domain_largest, domain_largest);
}

void move(Operands& operands, const std::function<double(double)>& x, const std::function<double(double)>& y) {
  for (RegionSet* soup : {&operands.a, &operands.b}) {
    for (Point& p : soup->points) p = {into_domain(x(p.x)), into_domain(y(p.y))};
  }
}

// The exponent e with 2^e <= value < 2^(e + 1).
int exponent_of(double value) { return std::ilogb(std::max(value, domain_smallest)); }

// One size, one cell of a grid for each: cell (i, j) is [4i, 4i + 2) x [4j, 4j + 2).
void put_in_rows(std::vector<CrowdMember>& members) {
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(members.size()))));
  for (std::size_t m = 0; m < members.size(); ++m) {
    const Box box = box_of(members[m].operands);
    if (box.empty()) continue;
    // With halves, because the width of a box may be twice the largest magnitude of the domain.
    const double size = std::max(box.x1 / 2 - box.x0 / 2, box.y1 / 2 - box.y0 / 2);
    const double scale = std::ldexp(1.0, -1 - exponent_of(size));
    const auto to_cell = [&](double low, std::size_t cell) -> std::function<double(double)> {
      return [=](double c) { return (c * scale - low * scale) + 4.0 * static_cast<double>(cell); };
    };
    move(members[m].operands, to_cell(box.x0, m % columns), to_cell(box.y0, m / columns));
  }
}

// Maps coordinates from [low, high] into (1/4, 2); only by a power of two and a sign, if they are clear of 0.
std::function<double(double)> clear_of_zero(double low, double high) {
  const double sign = low + high < 0 ? -1 : 1;
  const double least = sign < 0 ? -high : low, most = std::max(std::abs(low), std::abs(high));
  const double scale = sign * std::ldexp(1.0, -exponent_of(most));
  if (least > most / 4) return [=](double c) { return c * scale; };
  return [=](double c) { return (c * scale + 4) / 4; };
}

// Member m in cell (i, j) of one of the four quadrants, the interval (1/4, 2) times 8^i by that times 8^j.
void put_by_scale(std::vector<CrowdMember>& members) {
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(members.size()) / 4)));
  for (std::size_t m = 0; m < members.size(); ++m) {
    Operands& operands = members[m].operands;
    const Box box = box_of(operands);
    if (box.empty()) continue;
    const std::size_t cell = m / 4;
    const double x = std::ldexp(m % 2 == 0 ? 1.0 : -1.0, 3 * static_cast<int>(cell % columns));
    const double y = std::ldexp(m % 4 < 2 ? 1.0 : -1.0, 3 * static_cast<int>(cell / columns));
    const auto clear_x = clear_of_zero(box.x0, box.x1), clear_y = clear_of_zero(box.y0, box.y1);
    move(
        operands, [&](double c) { return clear_x(c) * x; }, [&](double c) { return clear_y(c) * y; });
  }
}

}  // namespace

void put_in_places(std::vector<CrowdMember>& members, Places places) {
  places == Places::row ? put_in_rows(members) : put_by_scale(members);
}

}  // namespace oblast::generators
