#include "noding/node_strands.h"

#include "base/call_memory.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "noding/merge_identical_edges.h"
#include "noding/resolve.h"
#include "noding/simple_ring.h"

namespace oblast::internal {
namespace {

using noding::Simplicity;
using noding::Strands;

/// The strands assumed to be simple that are not, sorted; all others are known to be then.
Array<std::uint32_t> find_tangled(Strands& strands) {
  Array<std::uint8_t> found(strands.size(), 0);
  for_ranges(strands.size(), tuning::strands_a_task, [&](std::size_t first, std::size_t past) {
    RingTree tree;
    for (std::size_t s = first; s < past; ++s) {
      if (strands.simplicity[s] == Simplicity::known) continue;
      const std::uint32_t begin = strands.begin(s);
      found[s] = is_tangled(std::span(strands.points).subspan(begin, strands.ends[s] - begin), tree);
      if (!found[s]) strands.simplicity[s] = Simplicity::known;
    }
  });
  Array<std::uint32_t> tangled;
  for (std::uint32_t s = 0; s < strands.size(); ++s)
    if (found[s]) tangled.push_back(s);
  return tangled;
}

}  // namespace

Strands node_strands(Strands strands, noding::NodingReport& report, const Resolve& resolve, std::uint64_t& resolved) {
  const auto checkpoint = [] { poll(); };
  const auto resolve_all = [&](const Array<std::uint32_t>& tangled) {
    resolved += tangled.size();
    strands = resolve_tangled(strands, tangled, resolve);
  };
  // Which way identical edges are found makes no difference to what is noded: whatever is not looked for is found by
  // the first round, which then asks for all of them to be merged.
  auto seek = strands.points.size() <= tuning::few_merged_vertices ? noding::Seek::no : noding::Seek::if_frequent;
  for (;;) {
    const noding::IdenticalEdges identical = noding::identical_edges(strands, seek);
    if (!identical.empty() && strands.has_assumed()) {
      if (const auto tangled = find_tangled(strands); !tangled.empty()) {
        resolve_all(tangled);
        continue;
      }
    }
    strands = noding::merge_identical_edges(std::move(strands), identical);
    report.first.seeks_identical = true;
    strands = noding::node(std::move(strands), report, checkpoint);
    const noding::FirstFindings first = std::move(report.first);
    if (!first.asks_for_change()) return strands;
    report = noding::NodingReport(report.measures_displacement);
    if (first.identical) seek = noding::Seek::all;
    if (!first.tangled.empty()) resolve_all(first.tangled);
  }
}

}  // namespace oblast::internal
