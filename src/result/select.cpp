#include "result/select.h"

#include "base/large_pages.h"
#include "base/parallel.h"
#include "base/tuning.h"

namespace oblast::internal {

Selection select(const ChainGraph& graph, const LargeArray<Winding>& right, Operation operation,
                 const Options& options) {
  const auto in_result = [&](Winding w) {
    return admits(operation, is_inside(options.fill_a, w.a), is_inside(options.fill_b, w.b));
  };
  Selection selection;
  resize_uninitialized(selection, graph.chains.size());
  for_ranges(graph.chains.size(), tuning::selected_chains_a_task, [&](std::size_t begin, std::size_t end) {
    for (auto c = static_cast<std::uint32_t>(begin); c < end; ++c) {
      selection[c] = none;
      if (!graph.is_live(c)) continue;
      const bool right_side = in_result(right[c]), left_side = in_result(right[c] + graph.chains[c].change);
      if (left_side == right_side) continue;
      selection[c] = left_side ? forward(c) : opposite(forward(c));
    }
  });
  return selection;
}

}  // namespace oblast::internal
