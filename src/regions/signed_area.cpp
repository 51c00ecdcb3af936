#include <oblast/region_set.h>

#include "base/public_call.h"
#include "regions/ring_area.h"
#include "regions/validate.h"

namespace oblast {
using namespace internal;
namespace {

double area_of(const RegionView& regions) {
  CompensatedSum sum;
  for (std::size_t c = 0; c < regions.contour_count(); ++c) add_ring_area(regions.contour(c), sum);
  return sum.value();
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
