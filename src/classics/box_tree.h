// A packed tree of boxes: which runs of edges come near a box.
#pragma once

#include <cstdint>
#include <vector>

#include "noding/monotone_runs.h"

namespace oblast::classics {

/// Runs sorted along a space-filling curve by their centres, four to a node, level upon level.
class BoxTree {
 public:
  explicit BoxTree(LargeArray<noding::Run> runs);

  /// Calls visit(run) for every run whose box meets `box`; stops and returns false when visit does.
  template <class Visit>
  bool each_near(const noding::Box& box, const Visit& visit) const {
    return runs_.empty() || visit_node(levels_.size(), 0, box, visit);
  }

 private:
  static constexpr std::size_t fan = 4;

  // Level 0 are the runs; levels_[k - 1] holds the boxes of level k; the last level is one box.
  template <class Visit>
  bool visit_node(std::size_t level, std::size_t index, const noding::Box& box, const Visit& visit) const {
    if (level == 0) return !runs_[index].box.meets(box) || visit(runs_[index]);
    if (!levels_[level - 1][index].meets(box)) return true;
    const std::size_t below = level == 1 ? runs_.size() : levels_[level - 2].size();
    for (std::size_t i = index * fan; i < std::min(below, (index + 1) * fan); ++i)
      if (!visit_node(level - 1, i, box, visit)) return false;
    return true;
  }

  LargeArray<noding::Run> runs_;
  std::vector<std::vector<noding::Box>> levels_;
};

}  // namespace oblast::classics
