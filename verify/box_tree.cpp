#include "verify/box_tree.h"

#include <numeric>

namespace oblast::verify {

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), items_(boxes_.size()) {
  std::iota(items_.begin(), items_.end(), 0u);
  if (!items_.empty()) build(0, 0, items_.size());
}

// Halves are cut at the median of the centres, along the longer side.
void BoxTree::build(std::size_t node, std::size_t begin, std::size_t end) {
  Box all;
  for (std::size_t k = begin; k < end; ++k) all.add(boxes_[items_[k]]);
  if (nodes_.size() <= node) nodes_.resize(2 * node + 1);
  nodes_[node] = all;
  if (end - begin <= leaf_size) return;
  const std::size_t middle = begin + (end - begin) / 2;
  const bool by_x = all.high.x - all.low.x >= all.high.y - all.low.y;
  const auto at = [&](std::size_t k) { return items_.begin() + static_cast<std::ptrdiff_t>(k); };
  std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t i, std::uint32_t j) {
    const Box &b = boxes_[i], &c = boxes_[j];
    return by_x ? b.low.x / 2 + b.high.x / 2 < c.low.x / 2 + c.high.x / 2
                : b.low.y / 2 + b.high.y / 2 < c.low.y / 2 + c.high.y / 2;
  });
  build(2 * node + 1, begin, middle);
  build(2 * node + 2, middle, end);
}

}  // namespace oblast::verify
