// Promise G1, round by round: every cut is made at a vertex there was, or at the correctly rounded intersection of the
// edge and another piece of that round, by exact rationals.
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <set>

#include "collect/collect.h"
#include "generators/hostile.h"
#include "noding/clearance.h"
#include "noding/insert_cuts.h"
#include "noding/meetings.h"
#include "noding/merge_identical_edges.h"
#include "noding/monotone_runs.h"
#include "overlay/pipeline.h"
#include "support/strands_of.h"
#include "verify/edges.h"
#include "verify/rational.h"

namespace oblast::internal::noding {
namespace {

using testing::edges_of;

/// The pieces of one round and what may be cut from them.
class Round {
 public:
  explicit Round(const Strands& strands) : points_(strands.points), edges_(edges_of(strands)) {
    for (const Point& p : points_) vertices_.emplace(p.x, p.y);
  }

  bool is_vertex(const Point& p) const { return vertices_.contains({p.x, p.y}); }

  bool is_rounded_intersection(const EdgeCut& cut) const {
    const Point &a = points_[cut.edge], &b = points_[cut.edge + 1], &p = cut.at;
    for (const std::uint32_t e : edges_) {
      const Point &c = points_[e], &d = points_[e + 1];
      if (e == cut.edge || !Box::of(c, d).meets(Box::of(p, p))) continue;
      const auto meeting = verify::intersection_of_segments(a, b, c, d);
      if (meeting && verify::round_into_domain(meeting->x) == p.x && verify::round_into_domain(meeting->y) == p.y)
        return true;
    }
    return false;
  }

 private:
  const LargeArray<Point>& points_;
  std::vector<std::uint32_t> edges_;
  std::set<std::pair<double, double>> vertices_;
};

/// As node() does it, with every cut looked at. How many rounds there were.
int check_rounds(Strands strands, const std::string& name) {
  strands.flags.assign(strands.points.size(), 0);
  for (int number = 1;; ++number) {
    const bool first = number == 1;
    std::optional<Clearance> clearance;
    if (first) clearance.emplace(strands);
    const auto cuts =
        find_meetings(strands, first ? Grouping::none : Grouping::by_moved,
                      Settling::of_round(static_cast<std::uint64_t>(number)), {}, clearance ? &*clearance : nullptr);
    if (cuts.empty()) return number;
    const Round round(strands);
    for (const EdgeCut& cut : cuts) {
      if (round.is_vertex(cut.at) || round.is_rounded_intersection(cut)) continue;
      ADD_FAILURE() << name << ", round " << number << ": a cut at " << verify::to_text(cut.at) << " from nowhere";
      return number;
    }
    insert_cuts(strands, cuts);
  }
}

TEST(Rounds, cutWhereThereIsAVertexOrARoundedIntersection) {
  int most = 0;
  tbb::task_arena(1).execute([&] {
    for (const auto& generator : generators::hostile_generators()) {
      for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        const generators::Operands operands = generator.make(seed, 24);
        const RegionView b = operands.b;
        Options options;
        options.fill_a = options.fill_b = FillRule::nonzero();
        Control control(options);
        Statistics statistics;
        Strands strands = collect(operands.a, &b, options, resolve_by_pipeline(control), statistics.resolved_polygons);
        most = std::max(most, check_rounds(merge_identical_edges(std::move(strands)),
                                           std::string(generator.name) + " seed " + std::to_string(seed)));
      }
    }
  });
  EXPECT_GE(most, 3) << "no case had cuts in a later round: then only the first was tested";
}

}  // namespace
}  // namespace oblast::internal::noding
