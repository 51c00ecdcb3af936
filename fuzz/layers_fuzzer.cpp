// Layers: numbered without gaps, and no two contours of one layer have an interior point in common, by exact rationals.
#include <oblast/layers.h>

#include <algorithm>

#include "bytes_to_operands.h"
#include "verify/slabs.h"

namespace {

using namespace oblast;

RegionSet alone(std::span<const Point> contour) {
  return {{contour.begin(), contour.end()}, {static_cast<std::uint32_t>(contour.size())}, {1}};
}

bool boxes_overlap(std::span<const Point> p, std::span<const Point> q) {
  if (p.empty() || q.empty()) return false;
  const auto apart = [&](double Point::*coordinate) {
    const auto less = [&](const Point& i, const Point& j) { return i.*coordinate < j.*coordinate; };
    const auto [p_low, p_high] = std::minmax_element(p.begin(), p.end(), less);
    const auto [q_low, q_high] = std::minmax_element(q.begin(), q.end(), less);
    return (*p_high).*coordinate <= (*q_low).*coordinate || (*q_high).*coordinate <= (*p_low).*coordinate;
  };
  return !apart(&Point::x) && !apart(&Point::y);
}

bool overlap(std::span<const Point> p, std::span<const Point> q) {
  if (!boxes_overlap(p, q)) return false;
  const RegionSet one = alone(p), other = alone(q);
  bool found = false;
  verify::for_each_trapezoid({{one, FillRule::even_odd()}, {other, FillRule::even_odd()}},
                             [&](const verify::Trapezoid& t) { found = found || (t.inside[0] && t.inside[1]); });
  return found;
}

const char* fault_of(const Layers& found, const RegionView& regions) {
  if (found.layer.size() != regions.contour_count()) return "not one layer a contour";
  for (std::uint32_t number = 0; number < found.count; ++number)
    if (std::count(found.layer.begin(), found.layer.end(), number) == 0) return "a layer without contours";
  for (std::size_t i = 0; i < found.layer.size(); ++i) {
    if (found.layer[i] >= found.count) return "a layer beyond the last";
    for (std::size_t j = 0; j < i; ++j)
      if (found.layer[i] == found.layer[j] && overlap(regions.contour(i), regions.contour(j))) return "overlap";
  }
  return nullptr;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  constexpr std::size_t most_vertices = 30;
  const fuzz::Input input = fuzz::input_from(bytes, size);
  const RegionSet& a = input.operands.a;
  if (a.points.size() > most_vertices) return 0;
  for (const LayerRule rule : {LayerRule::interiors, LayerRule::boxes}) {
    if (const char* what = fault_of(layers(a, rule), a))
      fuzz::report({generators::Broken::wrong, Operation::unite, what}, input);
  }
  return 0;
}
