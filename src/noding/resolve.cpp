#include "noding/resolve.h"

#include <algorithm>
#include <cstdlib>

#include "base/call.h"

namespace oblast::internal {

using noding::Strands;

bool append_resolved(const Resolved& resolved, noding::Winding winding, noding::Group group, Strands& strands) {
  const RegionView regions = resolved.regions;
  for (std::size_t c = 0; c < regions.contour_count(); ++c) {
    const std::span<const Point> ring = regions.contour(c);
    strands.points.insert(strands.points.end(), ring.begin(), ring.end());
    strands.points.push_back(ring[0]);
    strands.close_strand(winding, resolved.touches ? noding::any_group : group);
  }
  return resolved.met;
}

Strands resolve_tangled(const Strands& strands, const Array<std::uint32_t>& tangled, const Resolve& resolve) {
  Strands result;
  result.rules = strands.rules;
  result.points.reserve(strands.points.size());
  Steps steps(strands.size());
  for (std::uint32_t s = 0; s < strands.size(); ++s) {
    const auto ring = std::span(strands.points).subspan(strands.begin(s), strands.ends[s] - strands.begin(s));
    steps();
    if (std::binary_search(tangled.begin(), tangled.end(), s)) {
      poll();
      const Share share(static_cast<double>(ring.size()) / static_cast<double>(strands.points.size()));
      const std::uint32_t end = static_cast<std::uint32_t>(ring.size() - 1);  // not its closing point
      // It came in turned as its smallest vertex says; what comes back runs counter-clockwise.
      const noding::Winding winding{std::abs(strands.change[s].a), std::abs(strands.change[s].b)};
      append_resolved(resolve(RegionView{ring.first(end), std::span(&end, 1), {}}), winding, strands.group[s], result);
    } else {
      result.points.insert(result.points.end(), ring.begin(), ring.end());
      result.close_strand(strands.change[s], strands.group[s], strands.simplicity[s]);
    }
  }
  return result;
}

}  // namespace oblast::internal
