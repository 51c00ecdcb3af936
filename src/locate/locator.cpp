// Points by the cell of a grid that they are in; those in crowded cells by the tree of slabs.
#include <oblast/domain.h>
#include <oblast/locator.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/floating_point.h"
#include "base/public_call.h"
#include "base/tuning.h"
#include "locate/cell_grid.h"
#include "locate/slab_tree.h"
#include "regions/validate.h"

namespace oblast {
using namespace internal;
namespace {

locate::Edges edges_of(const RegionView& regions) {
  locate::Edges result;
  result.points.reserve(regions.points.size() + regions.contour_count());
  result.edges.reserve(regions.points.size());
  for (const std::span<const Point> contour : regions.contours()) {
    const auto add = [&](const Point& p, std::size_t first) {
      if (result.points.size() > first) {
        if (result.points.back() == p) return;
        result.edges.push_back(static_cast<locate::Index>(result.points.size() - 1));
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

struct Locator::Prepared {
  explicit Prepared(locate::Edges all) : grid(all) {
    if (!grid.has_crowds()) return;
    edges = std::move(all);
    const Charge charge(edges.edges.size() * locate::SlabTree::bytes_an_edge);
    slabs.emplace(edges);
  }

  Location location(locate::CellAnswer answer, const Point& p) const {
    return answer == locate::CellAnswer::crowded ? slabs->locate(p) : static_cast<Location>(answer);
  }
  [[gnu::noinline]] Location locate(const Point& p) const { return location(grid.locate(p), p); }
  [[gnu::noinline]] void locate(std::span<const Point> points, Location* locations) const {
    std::array<locate::CellAnswer, tuning::queries_a_block> answers;
    for (; !points.empty(); points = points.subspan(std::min(points.size(), answers.size()))) {
      const std::span<const Point> block = points.first(std::min(points.size(), answers.size()));
      grid.locate(block, answers.data());
      for (std::size_t i = 0; i < block.size(); ++i) *locations++ = location(answers[i], block[i]);
    }
  }

  locate::CellGrid grid;
  locate::Edges edges;  ///< where there are slabs
  std::optional<locate::SlabTree> slabs;
};

static_assert(static_cast<Location>(locate::CellAnswer::inside) == Location::inside);
static_assert(static_cast<Location>(locate::CellAnswer::boundary) == Location::boundary);

Locator::Locator(const RegionView& regions, const CallOptions& options)
    : prepared_(public_call(options, regions.points.size(), [&](Control&) {
        validate(regions, 0);
        const std::size_t points = regions.points.size() + regions.contour_count();
        check_count(points, "points of closed contours");
        const Charge charge(points * (sizeof(Point) + sizeof(locate::Index)));
        return std::make_unique<const Prepared>(edges_of(regions));
      })) {}

Locator::~Locator() = default;
Locator::Locator(Locator&&) noexcept = default;
Locator& Locator::operator=(Locator&&) noexcept = default;

Location Locator::locate(const Point& point) const {
  if (!in_domain(point.x) || !in_domain(point.y)) validate({&point, 1});
  const WithDefaultModes modes;
  return prepared_->locate(point);
}

void Locator::locate(std::span<const Point> points, std::span<Location> locations, const CallOptions& options) const {
  if (points.size() != locations.size())
    throw Error(ErrorCode::precondition, "there are " + std::to_string(points.size()) + " points, but " +
                                             std::to_string(locations.size()) + " locations");
  (void)public_call(options, points.size(), [&](Control&) {
    validate(points);
    for_ranges(points.size(), tuning::queries_a_task, [&](std::size_t begin, std::size_t end) {
      prepared_->locate(points.subspan(begin, end - begin), locations.data() + begin);
    });
    return true;
  });
}

}  // namespace oblast
