#include "classics/box_tree.h"

#include <algorithm>

namespace oblast::classics {
namespace {

using noding::Box;
using noding::Run;

/// 16 bits spread to every second place.
std::uint32_t spread(std::uint32_t v) {
  v = (v | v << 8) & 0x00ff00ff;
  v = (v | v << 4) & 0x0f0f0f0f;
  v = (v | v << 2) & 0x33333333;
  return (v | v << 1) & 0x55555555;
}

Box joined(const Box& p, const Box& q) {
  return {std::min(p.x0, q.x0), std::min(p.y0, q.y0), std::max(p.x1, q.x1), std::max(p.y1, q.y1)};
}

/// The place of a coordinate's cell, 0 to 65535, in [low, high].
std::uint32_t cell(double low, double high, double at) {
  const double fraction = high > low ? (at - low) / (high - low) : 0;
  return static_cast<std::uint32_t>(std::clamp(fraction, 0.0, 1.0) * 65535);
}

}  // namespace

BoxTree::BoxTree(LargeArray<Run> runs) : runs_(std::move(runs)) {
  if (runs_.empty()) return;
  Box all = runs_[0].box;
  for (const Run& run : runs_) all = joined(all, run.box);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order(runs_.size());
  for (std::uint32_t i = 0; i < runs_.size(); ++i) {
    const Box& b = runs_[i].box;
    order[i] = {
        spread(cell(all.x0, all.x1, b.x0 / 2 + b.x1 / 2)) | spread(cell(all.y0, all.y1, b.y0 / 2 + b.y1 / 2)) << 1, i};
  }
  std::sort(order.begin(), order.end());
  LargeArray<Run> sorted;
  sorted.reserve(runs_.size());
  for (const auto& [code, i] : order) sorted.push_back(runs_[i]);
  runs_ = std::move(sorted);

  std::vector<Box> below;
  for (const Run& run : runs_) below.push_back(run.box);
  do {
    std::vector<Box> level;
    for (std::size_t i = 0; i < below.size(); i += fan) {
      level.push_back(below[i]);
      for (std::size_t k = i + 1; k < std::min(below.size(), i + fan); ++k)
        level.back() = joined(level.back(), below[k]);
    }
    levels_.push_back(level);
    below = std::move(level);
  } while (below.size() > 1);
}

}  // namespace oblast::classics
