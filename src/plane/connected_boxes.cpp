// A binary tree over the boxes along a curve. From the lowest level upwards, each node connects boxes of its two halves
// that meet. Two nodes of a level have no boxes in common, so they work in parallel. Boxes that are already connected
// are skipped. If all boxes are connected, that is nearly everything.
#include "plane/connected_boxes.h"

#include <algorithm>
#include <array>

#include "base/disjoint_sets.h"
#include "base/large_pages.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "plane/curve_order.h"

namespace oblast::internal {
namespace {

constexpr std::size_t boxes_a_task = tuning::boxes_a_task;
/// A depth-first walk has at most three pending neighbours on each of 32 levels.
constexpr std::size_t stack_size = 128;

class Connector {
 public:
  Connector(std::span<const Box> boxes, const LargeArray<std::uint32_t>& order) : order_(order), sets_(boxes.size()) {
    for (std::size_t size = boxes.size(), end = 0;; size = range_count(size, 2)) {
      begins_.push_back(end);
      end += size;
      if (size > 1) continue;
      begins_.push_back(end);
      break;
    }
    resize_uninitialized(boxes_, begins_.back());
    resize_with_zeros(is_one_, begins_.back());
    for_ranges(boxes.size(), boxes_a_task, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        boxes_[i] = boxes[order[i]];
        is_one_[i] = 1;
      }
    });
  }

  LargeArray<std::uint32_t> run() {
    for (std::size_t level = 1; level + 1 < begins_.size(); ++level) {
      for_ranges(size(level), std::max<std::size_t>(1, boxes_a_task >> level), [&](std::size_t begin, std::size_t end) {
        for (std::size_t node = begin; node < end; ++node) close(level, node);
      });
    }
    LargeArray<std::uint32_t> component;
    resize_uninitialized(component, order_.size());
    Steps steps(order_.size());
    for (std::uint32_t i = 0; i < order_.size(); ++i) {
      steps();
      component[order_[i]] = sets_.find(i);
    }
    return component;
  }

 private:
  struct Pair {
    std::size_t level, i, j;
  };

  std::size_t size(std::size_t level) const { return begins_[level + 1] - begins_[level]; }
  Box& box(std::size_t level, std::size_t node) { return boxes_[begins_[level] + node]; }
  std::uint8_t& flag(std::size_t level, std::size_t node) { return is_one_[begins_[level] + node]; }
  static std::uint32_t first_leaf(std::size_t level, std::size_t node) {
    return static_cast<std::uint32_t>(node << level);
  }

  void close(std::size_t level, std::size_t node) {
    const std::size_t left = 2 * node, right = left + 1;
    box(level, node) = box(level - 1, left);
    if (right < size(level - 1)) {
      box(level, node) = box(level, node).joined(box(level - 1, right));
      if (!connect({level - 1, left, right})) connect_all(level, node);
    }
    is_one(level, node);
  }

  /// Connects boxes under i with boxes under j. False if that takes too many comparisons.
  bool connect(const Pair& nodes) {
    std::array<Pair, stack_size> stack;
    std::size_t on_stack = 0, looks = 0;
    const std::size_t most_looks = tuning::looks_a_connected_box << (nodes.level + 1);
    const auto push = [&](const Pair& p) {
      if (p.j < size(p.level) && box(p.level, p.i).meets(box(p.level, p.j))) stack[on_stack++] = p;
    };
    push(nodes);
    Steps steps;
    while (on_stack > 0) {
      steps();
      const auto [level, i, j] = stack[--on_stack];
      if (++looks > most_looks) return false;
      const std::uint32_t i_first = first_leaf(level, i), j_first = first_leaf(level, j);
      if (level == 0) {
        sets_.unite(i_first, j_first);
        continue;
      }
      if (is_one(level, i) && is_one(level, j) && sets_.find(i_first) == sets_.find(j_first)) continue;
      // First the pair that is adjacent on the curve.
      push({level - 1, 2 * i, 2 * j + 1});
      push({level - 1, 2 * i, 2 * j});
      push({level - 1, 2 * i + 1, 2 * j + 1});
      push({level - 1, 2 * i + 1, 2 * j});
    }
    return true;
  }

  /// True if all boxes under a node are known to be connected.
  bool is_one(std::size_t level, std::size_t node) {
    std::uint8_t& one = flag(level, node);
    if (one) return true;
    const std::size_t left = 2 * node, right = left + 1;
    one = flag(level - 1, left) &&
          (right == size(level - 1) || (flag(level - 1, right) && sets_.find(first_leaf(level - 1, left)) ==
                                                                      sets_.find(first_leaf(level - 1, right))));
    return one != 0;
  }

  void connect_all(std::size_t level, std::size_t node) {
    const std::uint32_t first = first_leaf(level, node);
    const auto past = static_cast<std::uint32_t>(std::min<std::size_t>(order_.size(), (node + 1) << level));
    for (std::uint32_t i = first + 1; i < past; ++i) sets_.unite(first, i);
    for (std::size_t below = 1; below < level; ++below)
      for (std::size_t n = first >> below; n <= (past - 1) >> below; ++n) flag(below, n) = 1;
  }

  const LargeArray<std::uint32_t>& order_;
  DisjointSets sets_;           ///< of places in the order
  LargeArray<Box> boxes_;       ///< by level; the boxes along the curve are the first level
  Array<std::uint8_t> is_one_;  ///< by node: all under it are known to be connected
  Array<std::size_t> begins_;   ///< by level
};

}  // namespace

ConnectedBoxes connected_boxes(LargeArray<Box> boxes) {
  ConnectedBoxes connected;
  if (boxes.empty()) return connected;
  connected.order = curve_order(boxes);
  Connector connector(boxes, connected.order);
  boxes = LargeArray<Box>();  // the tree has a copy along the curve; = {} would keep the memory
  connected.component = connector.run();
  return connected;
}

}  // namespace oblast::internal
