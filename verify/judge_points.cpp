// Locates points by walking.
//
// A walker stores where it is: inside which polygons, and the winding number of each contour around it. The edges that
// it crosses on a walk update this. So the set of points is halved, across the wider side of its box, until few points
// remain. Each set has a list of the edges that can reach its box, and a walker at the lower left corner of the box.
// From a corner to the next one, and from a corner to a point, the walker goes sideways and then up. This path stays in
// the box of the larger set, so all edges that it may cross are in that list.
//
//      +----------------+    points of one half: .
//      |         ......p|    their corner: o, the corner above: *
//      |         :      |
//      |    o----+ .    |    Afterwards every step is undone.
//      |    ' .     .   |
//      *----+-----------+
#include "verify/judge_points.h"

#include <algorithm>
#include <future>
#include <numeric>

#include "verify/slabs.h"
#include "verify/surroundings.h"
#include "verify/walker.h"

namespace oblast::verify {
namespace {

constexpr std::size_t few_points = 6;
constexpr std::size_t few_edges = 24;

using Edges32 = std::vector<std::uint32_t>;

struct Found {
  OracleReport report;
  std::size_t wrong_probe = static_cast<std::size_t>(-1);
  WrongPlace wrong;
};

class Judge {
 public:
  Judge(const Segments& segments, const Question& question, std::span<const Probe> probes, double bound)
      : segments_(segments),
        question_(question),
        probes_(probes),
        bound_(bound),
        margin_(bound + rounding_along(segments)),
        walker_(segments, Membership(question.rule_a, question.polygons_a, question.rule_b, question.polygons_b)) {}

  // Judges the probes with the given indices. Changes the order of the indices.
  Found run(std::span<std::uint32_t> order) {
    if (order.empty()) return {};
    Edges32 all(segments_.size());
    std::iota(all.begin(), all.end(), 0u);
    // A point left of everything and below everything, which is outside of everything.
    const Box& box = segments_.box();
    descend({box.x0, box.y0}, all, order);
    return std::move(found_);
  }

 private:
  Point at(std::uint32_t probe) const { return probes_[probe].at; }

  Box box_of(std::span<const std::uint32_t> order) const {
    const Point first = at(order.front());
    Box box{first.x, first.y, first.x, first.y};
    for (const std::uint32_t p : order) box.include(at(p));
    return box;
  }

  void descend(const Point& corner, const Edges32& above, std::span<std::uint32_t> order) {
    const Box box = box_of(order);
    const Point here{box.x0, box.y0};
    const std::size_t steps = walker_.walk(corner, here, above);
    Edges32 edges;
    std::copy_if(above.begin(), above.end(), std::back_inserter(edges),
                 [&](std::uint32_t e) { return may_reach(segments_[e], box, margin_); });
    if (order.size() <= few_points || edges.size() <= few_edges) {
      for (const std::uint32_t p : order) judge(p, here, edges);
    } else {
      const bool wide = box.x1 - box.x0 > box.y1 - box.y0;
      const auto middle = order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2);
      std::nth_element(order.begin(), middle, order.end(),
                       [&](std::uint32_t p, std::uint32_t q) { return wide ? at(p).x < at(q).x : at(p).y < at(q).y; });
      descend(here, edges, std::span(order.begin(), middle));
      descend(here, edges, std::span(middle, order.end()));
    }
    walker_.take_back(steps);
  }

  void judge(std::uint32_t probe, const Point& corner, const Edges32& edges) {
    const std::size_t steps = walker_.walk(corner, at(probe), edges);
    Surroundings around =
        look_around(segments_, at(probe), edges, bound_, probes_[probe].kind == ProbeKind::result_vertex);
    judge_here(probe, around);
    walker_.take_back(steps);
  }

  void judge_here(std::uint32_t probe, Surroundings& around) {
    const Membership& here = walker_.here();
    const bool in_a = here.in_a(), in_b = here.in_b();
    auto& count = found_.report.points[static_cast<int>(probes_[probe].kind)];
    const auto wrong = [&](const char* what) {
      if (probe < found_.wrong_probe) found_.wrong_probe = probe, found_.wrong = {what, at(probe), in_a, in_b};
    };
    if (around.near_an_edge && probes_[probe].kind == ProbeKind::result_vertex) {
      found_.report.largest_displacement = std::max(found_.report.largest_displacement, around.distance);
    }
    if (around.on_the_result) {
      if (!around.near_an_edge) return wrong("an edge of the result lies where no input edge is within the bound");
      ++(probes_[probe].kind == ProbeKind::result_vertex ? count.within_bound : count.too_near);
      return;
    }
    const int winding = here.result_winding();
    if (winding != 0 && winding != 1) return wrong("the result goes round this place more than once, or the wrong way");
    const MayBe may_be = may_be_selected(here.may_be_in_a(around.of_a), here.may_be_in_b(around.of_b));
    if (may_be.yes && may_be.no) {
      ++count.too_near;
      return;
    }
    ++(around.near_an_edge ? count.within_bound : count.certain);
    if (may_be.yes != (winding == 1)) {
      wrong(may_be.yes ? "outside of the result, but the operation says inside"
                       : "inside the result, but the operation says outside");
    }
  }

  MayBe may_be_selected(const MayBe& a, const MayBe& b) const {
    MayBe selected{false, false};
    for (const bool in_a : {false, true}) {
      for (const bool in_b : {false, true}) {
        if (!(in_a ? a.yes : a.no) || !(in_b ? b.yes : b.no)) continue;
        (selects(question_.operation, in_a, in_b) ? selected.yes : selected.no) = true;
      }
    }
    return selected;
  }

  const Segments& segments_;
  const Question& question_;
  std::span<const Probe> probes_;
  double bound_, margin_;
  Walker walker_;
  Found found_;
};

void add(OracleReport& sum, const OracleReport& more) {
  for (int k = 0; k < probe_kinds; ++k) {
    sum.points[k].certain += more.points[k].certain;
    sum.points[k].within_bound += more.points[k].within_bound;
    sum.points[k].too_near += more.points[k].too_near;
  }
  sum.largest_displacement = std::max(sum.largest_displacement, more.largest_displacement);
}

}  // namespace

std::optional<WrongPlace> judge_points(const Segments& segments, const Question& question,
                                       std::span<const Probe> probes, double bound, int threads, OracleReport& report) {
  std::vector<std::uint32_t> order(probes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t p, std::uint32_t q) { return probes[p].at.x < probes[q].at.x; });
  // Each thread gets a strip with the same number of points.
  std::vector<std::future<Found>> strips;
  strips.reserve(static_cast<std::size_t>(threads));
  for (int t = 0; t < threads; ++t) {
    const std::size_t first = order.size() * static_cast<std::size_t>(t) / static_cast<std::size_t>(threads);
    const std::size_t last = order.size() * static_cast<std::size_t>(t + 1) / static_cast<std::size_t>(threads);
    strips.push_back(std::async(std::launch::async, [&, part = std::span(order).subspan(first, last - first)] {
      return Judge(segments, question, probes, bound).run(part);
    }));
  }
  Found first_wrong;
  for (auto& strip : strips) {
    Found found = strip.get();
    add(report, found.report);
    if (found.wrong_probe < first_wrong.wrong_probe) first_wrong = std::move(found);
  }
  if (first_wrong.wrong.what.empty()) return std::nullopt;
  return first_wrong.wrong;
}

}  // namespace oblast::verify
