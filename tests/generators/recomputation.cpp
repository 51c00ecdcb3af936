// Recomputes a case with exact arithmetic.
#include "generators/recomputation.h"

#include <tbb/task_arena.h>

#include "engines/leonov_nikitin/label.h"
#include "support/graph_of.h"
#include "verify/against.h"
#include "verify/arrangement.h"

namespace oblast::generators {
using namespace internal;
namespace {

using verify::NodedArrangement;
using verify::WideInteger;

NodedArrangement arrangement_of(const ChainGraph& graph, const Options& options) {
  std::vector<verify::NodedEdge> edges;
  for (std::uint32_t c = 0; c < graph.chains.size(); ++c) {
    if (!graph.is_live(c)) continue;
    const Chain& chain = graph.chains[c];
    for (std::uint32_t v = chain.first; v < chain.last; ++v)
      edges.push_back({graph.point(v), graph.point(v + 1), chain.change.a, chain.change.b});
  }
  return {std::move(edges), options.fill_a, options.fill_b};
}

/// Twice the area of the contours of an operation, before traces are removed: then every vertex is a vertex of the
/// arrangement.
WideInteger twice_area(const ChainGraph& graph, const LargeArray<Winding>& right, Operation operation,
                       const Options& options, const NodedArrangement& arrangement) {
  const Selection selection = select(graph, right, operation, options);
  const Rings rings = contours_to_rings(graph, selection, link(graph, selection, options.contours));
  WideInteger area = 0;
  for (std::size_t r = 0; r < rings.size(); ++r)
    area += arrangement.twice_area_of(std::span(rings.points).subspan(rings.begin(r), rings.ends[r] - rings.begin(r)));
  return area;
}

std::optional<std::string> check(const ChainGraph& graph, const Options& options) {
  const NodedArrangement arrangement = arrangement_of(graph, options);
  if (const auto fault = arrangement.check_settled()) return fault->what;
  const NodedArrangement::Areas areas = arrangement.twice_areas();
  const LargeArray<Winding> right = leonov_nikitin::label(graph);
  WideInteger chosen[4];
  for (int o = 0; o < 4; ++o) {
    chosen[o] = twice_area(graph, right, static_cast<Operation>(o), options, arrangement);
    if (chosen[o] != areas.by_operation[o])
      return "contours of operation " + std::to_string(o) + " do not enclose the area that the winding numbers say";
  }
  const auto of = [&](Operation operation) -> const WideInteger& { return chosen[static_cast<int>(operation)]; };
  const WideInteger &both = of(Operation::intersection), &all = of(Operation::unite);
  const WideInteger &only_a = of(Operation::difference), &either = of(Operation::symmetric_difference);
  if (all + both != areas.a + areas.b) return "|A or B| + |A and B| is not |A| + |B|";
  if (only_a + both != areas.a) return "|A \\ B| + |A and B| is not |A|";
  if (either + both != all) return "|A xor B| + |A and B| is not |A or B|";
  return std::nullopt;
}

}  // namespace

std::optional<std::string> recompute_result(const Operands& operands, const Request& request, Operation operation,
                                            const RegionSet& result, std::size_t most_vertices) {
  if (operands.a.points.size() + operands.b.points.size() + result.points.size() > most_vertices) return std::nullopt;
  const auto fault = verify::check_against(operands.a, operands.b, operation, options_of(request), result);
  if (!fault) return std::nullopt;
  return fault->what;
}

std::optional<std::string> recompute_arrangement(const Operands& operands, const Request& request) {
  // Every pair of noded edges is tested.
  constexpr std::size_t most_vertices = 500;
  if (operands.a.points.size() + operands.b.points.size() > most_vertices) return std::nullopt;
  const Options options = options_of(request);
  tbb::task_arena one_thread(1);
  return one_thread.execute([&] {
    const RegionView b = operands.b;
    return check(testing::graph_of(operands.a, &b, options), options);
  });
}

}  // namespace oblast::generators
