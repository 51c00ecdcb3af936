#include "check/roles.h"

#include "base/parallel.h"
#include "exact/orientation.h"
#include "plane/smallest_vertex.h"

namespace oblast::internal::checking {
namespace {

Role role_of(std::span<const Point> contour, std::uint32_t begin) {
  const auto n = static_cast<std::uint32_t>(contour.size());
  const auto [first, repeated] = smallest_vertex(contour);
  for (std::uint32_t v = first, past = repeated ? n : first + 1; v < past; ++v) {
    if (contour[v] != contour[first]) continue;
    const std::uint32_t before = (v + n - 1) % n;
    if (exact::orientation(contour[before], contour[v], contour[(v + 1) % n]) < 0)
      return {true, begin + before, {contour[v], contour[before]}};
  }
  return {};
}

}  // namespace

Array<Role> roles_of(const RegionView& regions) {
  Array<Role> roles(regions.contour_count());
  for_ranges(roles.size(), grain(roles.size(), regions.points.size()), [&](std::size_t c, std::size_t end) {
    for (; c < end; ++c) roles[c] = role_of(regions.contour(c), regions.contour_begin(c));
  });
  return roles;
}

std::optional<Finding> find_bad_role(const RegionView& regions, const Array<Role>& roles) {
  for (std::uint32_t p = 0; p < regions.polygon_count(); ++p) {
    const std::uint32_t first = regions.polygon_begin(p), end = regions.polygon_end(p);
    for (std::uint32_t c = first; c < end; ++c) {
      if (roles[c].is_hole != (c == first)) continue;
      const std::uint32_t v = regions.contour_begin(c);
      return Finding{c == first ? FaultKind::outer_is_not_first : FaultKind::hole_is_outer, v, none, regions.points[v]};
    }
  }
  return {};
}

}  // namespace oblast::internal::checking
