// The same operand written in another order.
#include <algorithm>
#include <numeric>

#include "generators/soup.h"
#include "generators/trial.h"

namespace oblast::generators {
namespace {

void shuffle(std::vector<std::uint32_t>& order, Random& random) {
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  }
}

std::vector<std::uint32_t> numbers(std::uint32_t begin, std::uint32_t end) {
  std::vector<std::uint32_t> order(end - begin);
  std::iota(order.begin(), order.end(), begin);
  return order;
}

}  // namespace

RegionSet shuffled(const RegionSet& regions, const FillRule& rule, std::uint64_t seed) {
  Random random(seed);
  const RegionView view = regions;
  // The winding number of a single contour may change its sign if only the parity counts. All may change together if it
  // only counts whether the sum is zero.
  const bool reverse_any = rule.by_polygon() || rule.kind == FillRule::Kind::even_odd;
  const bool reverse_all = rule.kind == FillRule::Kind::nonzero && random.one_in(2);

  std::vector<std::uint32_t> polygons = numbers(0, static_cast<std::uint32_t>(view.polygon_count()));
  shuffle(polygons, random);
  RegionSet result;
  for (const std::uint32_t p : polygons) {
    std::vector<std::uint32_t> contours = numbers(view.polygon_begin(p), view.polygon_end(p));
    shuffle(contours, random);
    for (std::size_t c = 0; c < contours.size(); ++c) {
      const auto contour = view.contour(contours[c]);
      Ring ring(contour.begin(), contour.end());
      if (!ring.empty()) {
        std::rotate(ring.begin(), ring.begin() + random.below(static_cast<int>(ring.size())), ring.end());
      }
      if (reverse_all || (reverse_any && random.one_in(2))) ring = reversed(std::move(ring));
      c == 0 ? add_polygon(result, ring) : add_hole(result, ring);
    }
  }
  return result;
}

}  // namespace oblast::generators
