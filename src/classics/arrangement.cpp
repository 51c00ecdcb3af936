#include "classics/arrangement.h"

#include <algorithm>
#include <numeric>

#include "base/call_memory.h"
#include "classics/clearance.h"
#include "engines/leonov_nikitin/label.h"
#include "exact/orientation.h"
#include "noding/insert_cuts.h"
#include "noding/meetings.h"

namespace oblast::internal::classics {
namespace {

using noding::Group;
using noding::Strands;
using noding::Winding;

void append(const Array<Ring>& rings, Winding change, Group group, Strands& strands) {
  for (const Ring& ring : rings) {
    const std::size_t first = strands.points.size();
    strands.points.insert(strands.points.end(), ring.points.begin(), ring.points.end());
    strands.points.push_back(ring.points[0]);
    strands.close_strand(change, group);
    strands.flags.resize(strands.points.size(), 0);
    strands.flags[first] = strands.flags.back() = noding::closed_flag;
  }
}

/// Flags the ends: a closed strand that has a node begins and ends at one.
void flag_ends(Strands& strands) {
  for (std::size_t s = 0; s < strands.size(); ++s) {
    const auto first = strands.flags.begin() + strands.begin(s), last = strands.flags.begin() + strands.ends[s] - 1;
    if (std::none_of(first, last + 1, [](std::uint8_t f) { return (f & noding::node_flag) != 0; })) continue;
    *first |= noding::node_flag;
    *last |= noding::node_flag;
  }
}

LargeArray<noding::EdgeCut> meetings_of(Strands& strands) {
  return noding::find_meetings(strands, noding::Grouping::by_strand, {});
}

/// Sets the flags for is_clear(): only rounded crossings are added; only pieces that end at one are moved. A cut is not
/// a rounded crossing if a vertex of the input lies there, exactly on the edge that was cut.
Strands flagged_for_clearance(const ChainGraph& graph, std::span<const Point> input) {
  Array<bool> has_input(graph.node_count(), false);
  for (const Chain& chain : graph.chains)
    if (!chain.is_loop() && !(graph.strands.flags[chain.first] & noding::added_flag)) has_input[chain.from] = true;
  Strands flagged = graph.strands;
  for (std::uint8_t& f : flagged.flags) f &= static_cast<std::uint8_t>(~(noding::added_flag | noding::moved_flag));
  for (const Chain& chain : graph.chains) {
    if (chain.is_loop() || !(graph.strands.flags[chain.first] & noding::added_flag)) continue;
    const std::uint32_t edge = graph.strands.origin[chain.first];
    const bool exact =
        has_input[chain.from] && exact::orientation(input[edge], input[edge + 1], graph.point(chain.first)) == 0;
    if (!exact) flagged.flags[chain.first] |= noding::added_flag;
  }
  for (std::size_t v = 0; v + 1 < flagged.flags.size(); ++v)
    if ((flagged.flags[v] | flagged.flags[v + 1]) & noding::added_flag) flagged.flags[v] |= noding::moved_flag;
  return flagged;
}

}  // namespace

OwnMeetings find_own_meetings(const Array<Ring>& rings) {
  OwnMeetings found;
  Strands strands;
  append(rings, {1, 0}, noding::any_group, strands);
  const auto locate = [&](std::uint32_t vertex, std::uint32_t& ring, std::uint32_t& at) {
    ring = static_cast<std::uint32_t>(strands.strand_of(vertex));
    at = vertex - strands.begin(ring);
  };
  const auto cuts = meetings_of(strands);
  if (!cuts.empty()) {
    locate(cuts.front().edge, found.crossed_ring, found.crossed_vertex);
    return found;
  }
  found.touches = std::any_of(strands.flags.begin(), strands.flags.end(),
                              [](std::uint8_t f) { return (f & noding::node_flag) != 0; });
  flag_ends(strands);
  found.graph = build_chain_graph(strands);
  std::uint32_t doubled = none;  // the first edge that coincides with an earlier one
  for (const Chain& chain : found.graph.chains) {
    const Chain& kept = found.graph.chains[chain.merged_into];
    if (&kept != &chain) doubled = std::min(doubled, std::max(chain.first, kept.first));
  }
  if (doubled != none) locate(doubled, found.doubled_ring, found.doubled_vertex);
  return found;
}

OwnMeetings require_regular(const Operand& operand, const Array<Ring>& rings) {
  OwnMeetings found = find_own_meetings(rings);
  if (found.crossed_ring != none)
    operand.refuse("another edge crosses the edge from there, or ends inside it", rings[found.crossed_ring].contour,
                   rings[found.crossed_ring].source[found.crossed_vertex]);
  if (found.doubled_ring != none)
    operand.refuse("the edge from there coincides with another", rings[found.doubled_ring].contour,
                   rings[found.doubled_ring].source[found.doubled_vertex]);
  return found;
}

void require_one_side(const Operand& operand, const Array<Ring>& rings, const OwnMeetings& own, const char* why,
                      bool& interior_left) {
  const LargeArray<Winding> right = leonov_nikitin::label(own.graph);
  Array<std::uint32_t> along(right.size());  // the chains along the rings
  std::iota(along.begin(), along.end(), 0U);
  const auto first_of = [&](std::uint32_t c) { return own.graph.chains[c].first; };
  std::sort(along.begin(), along.end(), [&](std::uint32_t c, std::uint32_t d) { return first_of(c) < first_of(d); });
  interior_left = along.empty() || right[along[0]].a == 0;
  for (const std::uint32_t c : along) {
    if (right[c].a == (interior_left ? 0 : -1)) continue;
    const auto& strands = own.graph.strands;
    const std::size_t ring = strands.strand_of(first_of(c));
    operand.refuse(why, rings[ring].contour, rings[ring].source[first_of(c) - strands.begin(ring)]);
  }
}

Arrangement arrange(const Array<Ring>& a, bool a_touches, const Array<Ring>& b, bool b_touches) {
  Strands strands;
  append(a, {1, 0}, a_touches ? noding::any_group : 1, strands);
  append(b, {0, 1}, b_touches ? noding::any_group : 2, strands);
  const auto cuts = meetings_of(strands);
  Strands noded = strands;
  if (!cuts.empty()) noding::insert_cuts(noded, cuts);
  flag_ends(noded);
  Arrangement arrangement;
  arrangement.graph = build_chain_graph(std::move(noded));
  const ChainGraph& graph = arrangement.graph;
  arrangement.clear = cuts.empty() || is_clear(flagged_for_clearance(graph, strands.points));
  Array<Winding> seen(graph.node_count());
  for (const Chain& chain : graph.chains) {
    if (chain.is_loop()) continue;
    for (const std::uint32_t node : {chain.from, chain.to}) {
      Winding& at = seen[node];
      const bool was = at.a != 0 && at.b != 0;
      if (chain.change.a != 0) at.a = 1;
      if (chain.change.b != 0) at.b = 1;
      arrangement.meetings += !was && at.a != 0 && at.b != 0;
    }
  }
  return arrangement;
}

}  // namespace oblast::internal::classics
