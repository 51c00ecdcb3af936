#include "graph/locate_below.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "base/call_memory.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "graph/query_cells.h"
#include "graph/sweep_runs.h"

namespace oblast::internal {
namespace {

/// The runs under the sweep line, from below to above.
class Status {
 public:
  explicit Status(const SweepRuns& runs) : set_(Lower{&runs}), places_(runs.size()) {}

  /// REQUIRES: the sweep stands at the start of the run.
  void insert(std::uint32_t run) {
    if (spare_.empty()) {
      places_[run] = set_.insert(run).first;
      return;
    }
    auto node = std::move(spare_.back());
    spare_.pop_back();
    node.value() = run;
    places_[run] = set_.insert(std::move(node)).position;
  }

  void remove(std::uint32_t run) { spare_.push_back(set_.extract(places_[run])); }

  /// The highest run below the query, or none. REQUIRES: the sweep stands at the query.
  std::uint32_t highest_below(const BelowQuery& query) const {
    const auto it = set_.lower_bound(query);
    return it == set_.begin() ? none : *std::prev(it);
  }

 private:
  /// The order of the status. Of two runs compared the later one is being put in: the sweep stands at its start.
  struct Lower {
    using is_transparent = void;
    const SweepRuns* runs;

    bool operator()(std::uint32_t r, std::uint32_t s) const {
      if (r == s) return false;
      const Point &r_start = runs->start(r), &s_start = runs->start(s);
      if (lexicographically_less(r_start, s_start)) return runs->is_below(r, s_start, runs->second(s));
      return !runs->is_below(s, r_start, runs->second(r));
    }
    bool operator()(std::uint32_t r, const BelowQuery& query) const { return runs->is_below(r, query.p, query.q); }
  };
  using Set = std::set<std::uint32_t, Lower, CallAllocator<std::uint32_t>>;

  Set set_;
  /// Nodes of runs that finished are used again for others: allocations as many as the status is large. (libstdc++'s
  /// pool resource would do the same, but crashes when memory runs out.)
  Array<Set::node_type> spare_;
  Array<Set::iterator> places_;  ///< by run
};

/// The runs that hold queries, and where they start and finish.
class Sweep {
 public:
  /// Of some of the queries: `order`, sorted by p, not empty.
  Sweep(const ChainGraph& graph, std::span<const BelowQuery> queries, std::span<const std::uint32_t> order)
      : graph_(graph), queries_(queries), order_(order), cells_(queries, order), runs_(graph.strands.points) {}

  void add(std::uint32_t chain) {
    graph_.fetch_points_ahead(chain);
    const Chain& c = graph_.chains[chain];
    if (c.last - c.first == 1 && !may_hold_query(point(c.first), point(c.last))) return;
    for (std::uint32_t first = c.first; first < c.last;) {
      const bool rightward = lexicographically_less(point(first), point(first + 1));
      std::uint32_t last = first + 1;
      while (last < c.last && lexicographically_less(point(last), point(last + 1)) == rightward) ++last;
      const std::uint32_t begin = rightward ? first : last, end = rightward ? last : first;
      if (holds_query(begin, end)) runs_.add({begin, end, rightward ? 1 : -1, chain});
      first = last;
    }
  }

  /// Answers go to their places.
  void run(Array<Below>& answers) {
    sort_events();
    Status status(runs_);
    Steps steps(2 * runs_.size());
    for (const std::uint32_t query : order_) {
      advance(queries_[query].p, status, steps);
      const std::uint32_t below = status.highest_below(queries_[query]);
      if (below != none) answers[query] = {runs_[below].chain, runs_[below].step > 0};
    }
  }

 private:
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

  void sort_events() {
    starts_.resize(runs_.size());
    std::iota(starts_.begin(), starts_.end(), 0U);
    finishes_ = starts_;
    parallel_sort(starts_.begin(), starts_.end(), [&](std::uint32_t r, std::uint32_t s) {
      return lexicographically_less(runs_.start(r), runs_.start(s));
    });
    parallel_sort(finishes_.begin(), finishes_.end(), [&](std::uint32_t r, std::uint32_t s) {
      return lexicographically_less(runs_.finish(r), runs_.finish(s));
    });
  }

  /// Puts in the runs that start up to p, and takes out those that finish up to there. At one point runs finish before
  /// others start.
  void advance(const Point& p, Status& status, Steps& steps) {
    for (;;) {
      steps();
      const bool starts = next_start_ < starts_.size() && !lexicographically_less(p, runs_.start(starts_[next_start_]));
      const bool finishes =
          next_finish_ < finishes_.size() && !lexicographically_less(p, runs_.finish(finishes_[next_finish_]));
      if (finishes &&
          !(starts && lexicographically_less(runs_.start(starts_[next_start_]), runs_.finish(finishes_[next_finish_]))))
        status.remove(finishes_[next_finish_++]);
      else if (starts)
        status.insert(starts_[next_start_++]);
      else
        break;
    }
  }

  const ChainGraph& graph_;
  std::span<const BelowQuery> queries_;
  std::span<const std::uint32_t> order_;
  QueryCells cells_;
  SweepRuns runs_;
  Array<std::uint32_t> starts_, finishes_;  ///< runs, as they start and as they finish
  std::size_t next_start_ = 0, next_finish_ = 0;
};

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
