// The checks of a result, in an order in which each may rely on those before it.
#include "verify/contours.h"
#include "verify/sweep.h"
#include "verify/verify.h"

namespace oblast::verify {

std::optional<Fault> check_closed(const RegionView& regions, ContourConvention convention) {
  if (auto fault = check_offsets(regions)) return fault;
  const Edges edges(regions);
  if (auto fault = check_vertices(edges)) return fault;
  if (auto fault = check_plane(edges)) return fault;
  if (auto fault = check_walks(edges, convention)) return fault;
  return check_roles(edges);
}

std::optional<Fault> check_result(const RegionView& result, ContourConvention convention) {
  if (auto fault = check_closed(result, convention)) return fault;
  return check_canonical(result);
}

}  // namespace oblast::verify
