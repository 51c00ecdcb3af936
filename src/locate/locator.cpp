// The public locator.
#include <oblast/domain.h>
#include <oblast/locator.h>

#include <string>

#include "base/floating_point.h"
#include "base/public_call.h"
#include "base/tuning.h"
#include "locate/prepared_regions.h"
#include "regions/validate.h"

namespace oblast {
using namespace internal;

struct Locator::Prepared : locate::PreparedRegions {
  using PreparedRegions::PreparedRegions;
};

Locator::Locator(const RegionView& regions, const CallOptions& options)
    : prepared_(public_call(options, regions.points.size(), [&](Control&) {
        validate(regions, 0);
        const Charge charge(locate::Edges::bytes(regions));
        return std::make_unique<const Prepared>(locate::edges_of(regions));
      })) {}

Locator::~Locator() = default;
Locator::Locator(Locator&&) noexcept = default;
Locator& Locator::operator=(Locator&&) noexcept = default;

Location Locator::locate(const Point& point) const {
  if (!in_domain(point.x) || !in_domain(point.y)) validate({&point, 1});
  const WithDefaultModes modes;
  return prepared_->locate(point);
}

void Locator::locate(std::span<const Point> points, std::span<Location> locations, const CallOptions& options) const {
  if (points.size() != locations.size())
    throw Error(ErrorCode::precondition, "there are " + std::to_string(points.size()) + " points, but " +
                                             std::to_string(locations.size()) + " locations");
  (void)public_call(options, points.size(), [&](Control&) {
    validate(points);
    for_ranges(points.size(), tuning::queries_a_task, [&](std::size_t begin, std::size_t end) {
      prepared_->locate(points.subspan(begin, end - begin), locations.data() + begin);
    });
    return true;
  });
}

}  // namespace oblast
