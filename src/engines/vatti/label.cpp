// The scan: stops in lexicographic order, and at each stop the bounds that finish are replaced in the active
// edge list by those that start, from below to above.
//
//         \   /          finish: neighbours in the list by now, for nothing lies between them
//    ------ p ------     `under`, the highest active edge below p, is the one below the lowest of them;
//         /   \          only where none finishes (a local minimum) has it to be searched for
//        `under`
#include "engines/vatti/label.h"

#include <algorithm>

#include "engines/vatti/active_edges.h"
#include "engines/vatti/bounds.h"
#include "engines/vatti/passive.h"
#include "exact/orientation.h"

namespace oblast::vatti {
namespace {

class Scan {
 public:
  Scan(const ChainGraph& graph, std::span<const std::uint32_t> chains, std::vector<Winding>& right)
      : graph_(graph),
        right_(right),
        labelled_(graph.chains.size(), false),
        bounds_(find_bounds(graph, chains)),
        slot_of_(bounds_.bounds.size()),
        active_(graph.strands.points) {}

  void run() {
    for (const PlacedStop& placed : bounds_.order) pass(placed);
  }

 private:
  void pass(const PlacedStop& placed) {
    const Stop& stop = bounds_.stops[placed.stop];
    collect_starting(placed.p, stop);
    Slot under;
    if (stop.finish == none) {
      under = active_.find_below(placed.p);
    } else {
      under = slot_of_[stop.finish];
      while (under != ground && active_[under].top == placed.stop) under = active_.below(under);
    }

    // Slots of finishing bounds are given to starting ones; what is left over is erased or inserted.
    Slot slot = under;
    std::size_t started = 0;
    for (Slot next; (next = active_.above(slot)) != none && active_[next].top == placed.stop;) {
      if (started == starting_.size()) {
        active_.erase(next);
        continue;
      }
      active_[next] = start(starting_[started], active_[slot].above);
      slot_of_[starting_[started++]] = slot = next;
    }
    for (; started < starting_.size(); ++started) {
      slot = active_.insert_above(slot, start(starting_[started], active_[slot].above));
      slot_of_[starting_[started]] = slot;
    }
  }

  /// The bounds that start at p, from below to above.
  void collect_starting(const Point& p, const Stop& stop) {
    starting_.clear();
    for (std::uint32_t b = stop.start; b != none; b = bounds_.bounds[b].next_start) starting_.push_back(b);
    if (starting_.size() < 2) return;
    std::sort(starting_.begin(), starting_.end(),
              [&](std::uint32_t r, std::uint32_t s) { return exact::orientation(p, second(r), second(s)) > 0; });
  }

  /// The second vertex of a bound.
  const Point& second(std::uint32_t b) const {
    return graph_.point(bounds_.bounds[b].first + bounds_.bounds[b].step());
  }

  /// A bound with `below` under it: labels its chain, unless another bound of the chain has done so.
  ActiveEdge start(std::uint32_t b, Winding below) {
    const Bound& bound = bounds_.bounds[b];
    const Winding change = graph_.chains[bound.chain].change;
    if (!labelled_[bound.chain]) {
      labelled_[bound.chain] = true;
      right_[bound.chain] = bound.is_rightward() ? below : below - change;
    }
    const std::uint32_t next = bound.first + bound.step();
    return {graph_.point(bound.first),
            graph_.point(next),
            next,
            bound.step(),
            bound.last,
            bound.top,
            bound.is_rightward() ? below + change : below - change};
  }

  const ChainGraph& graph_;
  std::vector<Winding>& right_;
  std::vector<bool> labelled_;  ///< by chain
  Bounds bounds_;
  std::vector<Slot> slot_of_;  ///< by bound, while it is active
  ActiveEdges active_;
  std::vector<std::uint32_t> starting_;
};

}  // namespace

std::vector<Winding> label(const ChainGraph& graph) {
  std::vector<Winding> right(graph.chains.size());
  std::vector<std::uint32_t> chains;
  std::size_t loops = 0;
  for (std::uint32_t c = 0; c < graph.chains.size(); ++c) {
    if (!graph.is_live(c)) continue;
    chains.push_back(c);
    loops += graph.chains[c].is_loop();
  }
  // 1. Where most chains are pieces of contours that meet others, looking for passive ones does not pay.
  if (2 * loops > chains.size()) chains = label_passive(graph, chains, right);
  // 2 and 3.
  Scan(graph, chains, right).run();
  return right;
}

}  // namespace oblast::vatti
