// The scan visits the stops in lexicographic order. At each stop, the bounds that start replace the bounds that end in
// the active edge list, from bottom to top.
//
//         \   /          The bounds that end at p are neighbours in the list, because nothing lies between them.
//    ------ p ------     `under`, the highest active edge below p, is the one below the lowest of them. If no bound
//         /   \          ends at p (a local minimum), `under` must be searched.
//        `under`
#include "engines/vatti/label.h"

#include "base/call.h"
#include "base/call_memory.h"
#include "engines/vatti/active_edges.h"
#include "engines/vatti/bounds.h"
#include "engines/vatti/passive.h"

namespace oblast::internal::vatti {
namespace {

class Scan {
 public:
  Scan(const ChainGraph& graph, std::span<const std::uint32_t> chains, LargeArray<Winding>& right)
      : bounds_(find_bounds(graph, chains)),
        right_(right),
        finishing_(bounds_.stop_count(), none),
        active_(graph.strands.points) {}

  void run() {
    Steps steps(bounds_.stop_count());
    for (std::uint32_t stop = 0; stop < bounds_.stop_count(); ++stop) {
      steps();
      pass(stop);
    }
  }

 private:
  void pass(std::uint32_t stop) {
    const Point& p = bounds_.stops[stop].p;
    Slot slot = finishing_[stop];
    if (slot == none) {
      slot = active_.find_below(p);
    } else {
      while (slot != ground && active_[slot].top == stop) slot = active_.below(slot);
    }

    // Starting bounds get the slots of ending bounds. The remaining ones are erased or inserted.
    const std::span<const Bound> starting = bounds_.starting_at(stop);
    std::size_t started = 0;
    for (Slot next; (next = active_.above(slot)) != none && active_[next].top == stop;) {
      if (started == starting.size()) {
        active_.erase(next);
        continue;
      }
      const Bound& bound = starting[started++];
      active_[next] = start(p, bound, active_[slot].above);
      finishing_[bound.top] = slot = next;
    }
    for (; started < starting.size(); ++started) {
      const Bound& bound = starting[started];
      finishing_[bound.top] = slot = active_.insert_above(slot, start(p, bound, active_[slot].above));
    }
  }

  /// Labels the chain of a bound. `below`: the winding numbers below it. All bounds of a chain give it the same label.
  ActiveEdge start(const Point& p, const Bound& bound, Winding below) {
    const Winding above = below + bound.change;
    right_[bound.chain] = bound.is_rightward() ? below : above;
    return {p, bound.second, bound.first + bound.step(), bound.step(), bound.last, bound.top, above};
  }

  const Bounds bounds_;
  LargeArray<Winding>& right_;
  Array<Slot> finishing_;  ///< by stop: slot of an active bound that ends there
  ActiveEdges active_;
};

}  // namespace

LargeArray<Winding> label(const ChainGraph& graph) {
  LargeArray<Winding> right(graph.chains.size(), Winding{});
  Array<std::uint32_t> chains;
  std::size_t loops = 0;
  for (std::uint32_t c = 0; c < graph.chains.size(); ++c) {
    if (!graph.is_live(c)) continue;
    chains.push_back(c);
    loops += graph.chains[c].is_loop();
  }
  // 1. If most chains are pieces of contours that meet others, the search for passive contours costs more than it
  // saves.
  if (2 * loops > chains.size()) chains = label_passive(graph, chains, right);
  // 2 and 3.
  Scan(graph, chains, right).run();
  return right;
}

}  // namespace oblast::internal::vatti
