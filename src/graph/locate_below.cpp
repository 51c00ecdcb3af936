#include "graph/locate_below.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "base/call_memory.h"
#include "base/counting_sort.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "exact/orientation.h"

namespace oblast::internal {
namespace {

/// A lexicographically monotone stretch of a chain, walked from its smaller end by a cursor.
struct SweepRun {
  std::uint32_t cursor;  ///< vertex where the edge under the sweep begins
  std::uint32_t end;     ///< vertex where the run ends
  std::int32_t step;     ///< 1 when the chain runs to the right, -1 when to the left
  std::uint32_t chain;
};

/// How many queries lie before each of equal cells along x: most edges have none in theirs.
class QueryCells {
 public:
  /// Of the queries in `order`, sorted by p.
  QueryCells(std::span<const BelowQuery> queries, std::span<const std::uint32_t> order)
      : count_(4 * order.size()), before_(count_ + 1) {
    low_ = queries[order.front()].p.x;
    const double scale = static_cast<double>(count_) / (queries[order.back()].p.x - low_);
    if (std::isfinite(scale)) scale_ = scale;
    count_begins(before_, [&](const auto& visit) {
      for (const std::uint32_t i : order) visit(cell_of(queries[i].p.x), i);
    });
  }

  /// Places in `order` among which those between two x are.
  std::pair<std::uint32_t, std::uint32_t> between(double x0, double x1) const {
    return {before_[cell_of(x0)], before_[cell_of(x1) + 1]};
  }

 private:
  std::size_t cell_of(double x) const {
    return static_cast<std::size_t>(std::clamp((x - low_) * scale_, 0.0, static_cast<double>(count_ - 1)));
  }

  std::size_t count_;
  double low_, scale_ = 0;
  Array<std::uint32_t> before_;
};

class Sweep {
 public:
  /// Of some of the queries: `order`, sorted by p, not empty.
  Sweep(const ChainGraph& graph, std::span<const BelowQuery> queries, std::span<const std::uint32_t> order)
      : graph_(graph), queries_(queries), order_(order), cells_(queries, order) {}

  void add(std::uint32_t chain) {
    graph_.fetch_points_ahead(chain);
    const Chain& c = graph_.chains[chain];
    if (c.last - c.first == 1 && !may_hold_query(point(c.first), point(c.last))) return;
    for (std::uint32_t first = c.first; first < c.last;) {
      const bool rightward = lexicographically_less(point(first), point(first + 1));
      std::uint32_t last = first + 1;
      while (last < c.last && lexicographically_less(point(last), point(last + 1)) == rightward) ++last;
      const std::uint32_t begin = rightward ? first : last, end = rightward ? last : first;
      if (holds_query(begin, end)) runs_.push_back({begin, end, rightward ? 1 : -1, chain});
      first = last;
    }
  }

  /// Answers go to their places.
  void run(Array<Below>& answers);

 private:
  /// The order of the status, from below to above. Of two runs compared the later one is being put in:
  /// the sweep stands at its start.
  struct Lower {
    using is_transparent = void;
    Sweep* sweep;

    bool operator()(std::uint32_t r, std::uint32_t s) const {
      if (r == s) return false;
      const Point &r_start = sweep->start_points_[r], &s_start = sweep->start_points_[s];
      if (lexicographically_less(r_start, s_start)) return sweep->is_below(r, s_start, sweep->edge_end(s));
      return !sweep->is_below(s, r_start, sweep->edge_end(r));
    }
    bool operator()(std::uint32_t r, const BelowQuery& query) const { return sweep->is_below(r, query.p, query.q); }
  };

  const Point& edge_end(std::uint32_t r) const { return point(runs_[r].cursor + runs_[r].step); }
  const Point& point(std::uint32_t vertex) const { return graph_.strands.points[vertex]; }

  bool may_hold_query(const Point& p, const Point& q) const {
    const auto [first, past] = cells_.between(std::min(p.x, q.x), std::max(p.x, q.x));
    return first != past;
  }

  bool holds_query(std::uint32_t begin, std::uint32_t end) const {
    const auto [first, past] = cells_.between(point(begin).x, point(end).x);
    const auto it =
        std::lower_bound(order_.begin() + first, order_.begin() + past, point(begin),
                         [&](std::uint32_t i, const Point& p) { return lexicographically_less(queries_[i].p, p); });
    return it != order_.begin() + past && lexicographically_less(queries_[*it].p, point(end));
  }

  /// True when the run passes below the edge (p, q), where p is where the sweep stands.
  bool is_below(std::uint32_t r, const Point& p, const Point& q) {
    SweepRun& run = runs_[r];
    std::uint32_t next = run.cursor + run.step;
    while (next != run.end && !lexicographically_less(p, point(next))) {
      run.cursor = next;
      next += run.step;
    }
    const Point &a = point(run.cursor), &b = point(next);
    return a == p ? exact::orientation(p, b, q) > 0 : exact::orientation(a, b, p) > 0;
  }

  const ChainGraph& graph_;
  std::span<const BelowQuery> queries_;
  std::span<const std::uint32_t> order_;
  QueryCells cells_;
  Array<SweepRun> runs_;
  Array<Point> start_points_;
};

void Sweep::run(Array<Below>& answers) {
  Array<std::uint32_t> starts(runs_.size()), finishes(runs_.size());
  std::iota(starts.begin(), starts.end(), 0U);
  std::iota(finishes.begin(), finishes.end(), 0U);
  start_points_.resize(runs_.size());
  for (std::size_t r = 0; r < runs_.size(); ++r) start_points_[r] = point(runs_[r].cursor);
  parallel_sort(starts.begin(), starts.end(), [&](std::uint32_t r, std::uint32_t s) {
    return lexicographically_less(start_points_[r], start_points_[s]);
  });
  parallel_sort(finishes.begin(), finishes.end(), [&](std::uint32_t r, std::uint32_t s) {
    return lexicographically_less(point(runs_[r].end), point(runs_[s].end));
  });

  // Nodes of runs that finished are used again for others: allocations as many as the status is large. (libstdc++'s
  // pool resource would do the same, but crashes when memory runs out.)
  std::set<std::uint32_t, Lower, CallAllocator<std::uint32_t>> status(Lower{this});
  Array<decltype(status)::node_type> spare;
  const auto insert = [&](std::uint32_t run) {
    if (spare.empty()) return status.insert(run).first;
    auto node = std::move(spare.back());
    spare.pop_back();
    node.value() = run;
    return status.insert(std::move(node)).position;
  };
  Array<decltype(status)::iterator> places(runs_.size());

  std::size_t next_start = 0, next_finish = 0;
  Steps steps(2 * runs_.size());
  for (const std::uint32_t query : order_) {
    const Point& p = queries_[query].p;
    // In order: at one point runs finish before others start.
    for (;;) {
      steps();
      const bool starting = next_start < starts.size() && !lexicographically_less(p, start_points_[starts[next_start]]);
      const bool finishing =
          next_finish < finishes.size() && !lexicographically_less(p, point(runs_[finishes[next_finish]].end));
      if (finishing && !(starting && lexicographically_less(start_points_[starts[next_start]],
                                                            point(runs_[finishes[next_finish]].end)))) {
        spare.push_back(status.extract(places[finishes[next_finish++]]));
      } else if (starting) {
        const std::uint32_t r = starts[next_start++];
        places[r] = insert(r);
      } else {
        break;
      }
    }
    const auto it = status.lower_bound(queries_[query]);
    if (it == status.begin()) continue;
    const SweepRun& below = runs_[*std::prev(it)];
    answers[query] = {below.chain, below.step > 0};
  }
}

}  // namespace

Array<Below> locate_below(const ChainGraph& graph, std::span<const std::uint32_t> chains,
                          std::span<const BelowQuery> queries) {
  if (queries.empty()) return {};
  Array<std::uint32_t> order(queries.size());
  std::iota(order.begin(), order.end(), 0U);
  parallel_sort(order.begin(), order.end(),
                [&](std::uint32_t i, std::uint32_t j) { return lexicographically_less(queries[i].p, queries[j].p); });
  // Slabs side by side, one a core: each has a sweep of its own, over the runs that hold a query of its.
  const std::size_t queries_a_slab = std::max(tuning::fewest_queries, range_count(order.size(), core_count()));
  Array<Below> answers(queries.size());
  for_numbered_ranges(order.size(), queries_a_slab, [&](std::size_t, std::size_t begin, std::size_t end) {
    Sweep sweep(graph, queries, std::span(order).subspan(begin, end - begin));
    Steps steps(chains.size());
    for (const std::uint32_t chain : chains) {
      steps();
      sweep.add(chain);
    }
    sweep.run(answers);
  });
  return answers;
}

}  // namespace oblast::internal
