#include "noding/coarse_boxes.h"

#include <algorithm>
#include <limits>

#include "base/counting_sort.h"
#include "base/tuning.h"

namespace oblast::internal::noding {
namespace {

constexpr std::int16_t below_all = std::numeric_limits<std::int16_t>::min(), lowest = below_all + 1,
                       highest = std::numeric_limits<std::int16_t>::max();

/// Values of one axis to cells. Monotone, so what meets does so on the grid.
struct Scale {
  double low, factor;

  Scale(double from, double to) : low(from), factor(to > from ? (highest - lowest) / (to - from) : 0) {}
  std::int16_t operator()(double value) const {
    return static_cast<std::int16_t>(static_cast<std::int32_t>((value - low) * factor) + lowest);
  }
};

}  // namespace

void CoarseBoxes::assign(std::span<const Run> runs) {
  const std::size_t size = runs.size();
  blocks_.resize((size + block - 1) / block);
  order_.resize(size);
  Box around = runs[0].box;
  double widths = 0, heights = 0;
  for (const Run& run : runs) {
    around = around.joined(run.box);
    widths += run.box.x1 - run.box.x0;
    heights += run.box.y1 - run.box.y0;
  }
  // Along the axis on which boxes are shorter.
  const bool swaps = widths * (around.y1 - around.y0) > heights * (around.x1 - around.x0);
  const auto turned = [&](Box box) { return swaps ? Box{box.y0, box.x0, box.y1, box.x1} : box; };
  around = turned(around);
  const Scale x(around.x0, around.x1), y(around.y0, around.y1);
  const auto put = [&](std::size_t slot, std::size_t i) {
    const Box box = turned(runs[i].box);
    order_[slot] = static_cast<std::uint32_t>(i);
    Block& to = blocks_[slot / block];
    const std::size_t k = slot % block;
    to.x0[k] = x(box.x0);
    to.y0[k] = y(box.y0);
    to.x1[k] = x(box.x1);
    to.y1[k] = y(box.y1);
  };
  if (size > tuning::few_boxes) {
    const auto for_each_run = [&](const auto& visit) {
      for (std::size_t i = 0; i < size; ++i) visit(bucket_of(x(turned(runs[i].box).x0)), i);
    };
    count_begins(past_, for_each_run);
    put_in_places(past_, for_each_run, put);
  } else {
    past_.fill(static_cast<std::uint32_t>(size));
    for (std::size_t i = 0; i < size; ++i) put(i, i);
  }
  // Nothing meets what is left of the last block.
  Block& last = blocks_.back();
  for (std::size_t k = (size - 1) % block + 1; k < block; ++k) {
    last.x0[k] = last.y0[k] = highest;
    last.x1[k] = last.y1[k] = below_all;
  }
}

}  // namespace oblast::internal::noding
