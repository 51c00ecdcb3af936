// The public check, step by step: each may rely on what those before it did not find.
#include <oblast/check.h>

#include "base/public_call.h"
#include "base/stage_shares.h"
#include "check/faces.h"
#include "check/form.h"
#include "check/meetings.h"
#include "check/order.h"
#include "check/report.h"
#include "check/roles.h"
#include "check/strands_of.h"
#include "check/touches.h"
#include "graph/chain_graph.h"

namespace oblast {
using namespace internal;
namespace {

using checking::Finding;

std::optional<Finding> find_in_plane(const RegionView& regions, ContourConvention convention) {
  noding::Strands strands = checking::strands_of(regions);
  {
    const Share share(Stage::node, check_meetings_share);
    if (auto finding = checking::find_bad_meeting(strands)) return finding;
  }
  const Share share(Stage::label, check_faces_share);
  const ChainGraph graph = build_chain_graph(std::move(strands));
  if (auto finding = checking::find_bad_touch(graph, convention)) return finding;
  if (auto finding = checking::find_wrong_side(graph)) return finding;
  const Array<checking::Role> roles = checking::roles_of(regions);
  if (auto finding = checking::find_bad_role(regions, roles)) return finding;
  return checking::find_bad_face(regions, graph, roles);
}

std::optional<Finding> find_first(const RegionView& regions, const CheckOptions& options) {
  if (auto finding = checking::find_bad_vertex(regions)) return finding;
  if (auto finding = find_in_plane(regions, options.contours)) return finding;
  if (options.order == CheckedOrder::any) return {};
  const Share share(Stage::assemble, 1);
  return checking::find_bad_order(regions);
}

}  // namespace

CheckReport check(const RegionView& regions, const CheckOptions& options) {
  check_enumerator(options.contours, ContourConvention::leonov_nikitin, "ContourConvention");
  check_enumerator(options.order, CheckedOrder::any, "CheckedOrder");
  return public_call(options, regions.points.size(), [&](Control&) {
    CheckReport report;
    if (const auto bad_offsets = checking::find_bad_offsets(regions))
      report.fault = Fault{FaultKind::bad_offsets, {}, {}, {}, *bad_offsets};
    else if (const auto finding = find_first(regions, options))
      report.fault = checking::report_of(regions, *finding);
    return report;
  });
}

}  // namespace oblast
