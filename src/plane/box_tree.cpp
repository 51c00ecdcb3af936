#include "plane/box_tree.h"

#include "plane/curve_order.h"
#include "plane/empty_box.h"

namespace oblast::internal {
namespace {

/// Meets nothing, and adds nothing to what it is joined to.

}  // namespace

BoxTree::BoxTree(std::span<const Box> boxes) : order_(curve_order(boxes)) {
  place_.resize(boxes.size());
  boxes_.reserve(boxes.size() + boxes.size() / 2);
  begins_.push_back(0);
  for (std::uint32_t place = 0; place < order_.size(); ++place) {
    place_[order_[place]] = place;
    boxes_.push_back(boxes[order_[place]]);
  }
  begins_.push_back(boxes_.size());
  while (boxes_.size() - begins_[begins_.size() - 2] > 1) {
    const std::size_t begin = begins_[begins_.size() - 2], end = begins_.back();
    for (std::size_t i = begin; i < end; i += fan) {
      Box node = empty_box;
      for (std::size_t k = i; k < std::min(end, i + fan); ++k) node = node.joined(boxes_[k]);
      boxes_.push_back(node);
    }
    begins_.push_back(boxes_.size());
  }
}

void BoxTree::replace(std::uint32_t i, const Box& box) {
  std::size_t place = place_[i];
  boxes_[place] = box;
  for (std::size_t level = 1; level + 1 < begins_.size(); ++level) {
    place /= fan;
    Box& node = boxes_[begins_[level] + place];
    node = node.joined(box);
  }
}

void BoxTree::remove(std::uint32_t i) { boxes_[place_[i]] = empty_box; }

}  // namespace oblast::internal
