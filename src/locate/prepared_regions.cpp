#include "locate/prepared_regions.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/memory_budget.h"
#include "base/tuning.h"

namespace oblast::internal::locate {
static_assert(static_cast<Location>(CellAnswer::inside) == Location::inside);
static_assert(static_cast<Location>(CellAnswer::boundary) == Location::boundary);

PreparedRegions::PreparedRegions(Edges edges) : edges_(std::move(edges)), grid_(edges_) {
  if (!grid_.has_crowds()) {
    edges_ = {};
    return;
  }
  const Charge charge(edges_.edges.size() * SlabTree::bytes_an_edge);
  slabs_.emplace(edges_);
}

[[gnu::noinline]] Location PreparedRegions::locate(const Point& p) const { return location(grid_.locate(p), p); }

[[gnu::noinline]] void PreparedRegions::locate(std::span<const Point> points, Location* locations) const {
  std::array<CellAnswer, tuning::queries_a_block> answers;
  for (; !points.empty(); points = points.subspan(std::min(points.size(), answers.size()))) {
    const std::span<const Point> block = points.first(std::min(points.size(), answers.size()));
    grid_.locate(block, answers.data());
    for (std::size_t i = 0; i < block.size(); ++i) *locations++ = location(answers[i], block[i]);
  }
}

}  // namespace oblast::internal::locate
