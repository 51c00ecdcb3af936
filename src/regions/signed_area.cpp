#include <oblast/region_set.h>

#include "base/public_call.h"
#include "regions/validate.h"

namespace oblast {
using namespace internal;
namespace {

double area_of(const RegionView& regions) {
  // Coordinates relative to the contour's first vertex: small terms, little cancellation. Neumaier's sum.
  double sum = 0, compensation = 0;
  for (std::size_t c = 0; c < regions.contour_count(); ++c) {
    const auto ring = regions.contour(c);
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      const Point &o = ring[0], &p = ring[i], &q = ring[i + 1];
      const double term = ((p.x - o.x) * (q.y - o.y) - (q.x - o.x) * (p.y - o.y)) / 2;
      const double next = sum + term;
      const bool sum_larger = (sum < 0 ? -sum : sum) >= (term < 0 ? -term : term);
      compensation += sum_larger ? (sum - next) + term : (term - next) + sum;
      sum = next;
    }
  }
  return sum + compensation;
}

}  // namespace

double signed_area(const RegionView& regions) {
  CallOptions options;
  options.threads = 1;
  return public_call(options, regions.points.size(), [&](Control&) {
    validate(regions, 0);
    return area_of(regions);
  });
}

}  // namespace oblast
