#include "locate/prepared_regions.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/memory_budget.h"
#include "base/tuning.h"

namespace oblast::internal::locate {
namespace {

Edges edges_of(const RegionView& regions) {
  Edges result;
  result.points.reserve(regions.points.size() + regions.contour_count());
  result.edges.reserve(regions.points.size());
  for (const std::span<const Point> contour : regions.contours()) {
    const auto add = [&](const Point& p, std::size_t first) {
      if (result.points.size() > first) {
        if (result.points.back() == p) return;
        result.edges.push_back(static_cast<Index>(result.points.size() - 1));
      }
      result.points.push_back({p.x + 0.0, p.y + 0.0});  // -0.0 becomes 0.0
    };
    const std::size_t first = result.points.size();
    for (const Point& p : contour) add(p, first);
    if (!contour.empty()) add(contour.front(), first);
  }
  return result;
}

}  // namespace

static_assert(static_cast<Location>(CellAnswer::inside) == Location::inside);
static_assert(static_cast<Location>(CellAnswer::boundary) == Location::boundary);

PreparedRegions::PreparedRegions(const RegionView& regions) : edges_(edges_of(regions)), grid_(edges_) {
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
