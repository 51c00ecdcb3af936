#include "noding/pair_finder.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>

#include "base/large_pages.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "noding/cell_cut.h"
#include "noding/choose_cut.h"
#include "noding/coarse_boxes.h"
#include "plane/empty_box.h"

namespace oblast::internal::noding {
namespace {

constexpr std::size_t leaf_size = runs_of_one_cell;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The part of the plane that runs are looked at in, or a box around it where edges cut it off.
struct Cell {
  Box box{-infinity, -infinity, infinity, infinity};
  bool clipped = false;

  std::pair<Cell, Cell> halves(const CellCut& cut) const {
    Cell left = *this, right = *this;
    if (cut.kind != CutKind::along_edge) {
      (cut.kind == CutKind::at_x ? left.box.x1 : left.box.y1) = cut.at;
      (cut.kind == CutKind::at_x ? right.box.x0 : right.box.y0) = cut.at;
    }
    return {left, right};
  }
};

bool one_group(std::span<const Run> runs) {
  if (runs.empty()) return true;
  const Group group = runs[0].group;
  if (group == any_group) return false;
  return std::all_of(runs.begin(), runs.end(), [&](const Run& e) { return e.group == group; });
}

/// Pairs on their way to the visitor.
class PairBatch {
 public:
  explicit PairBatch(const PairVisitor& visit) : visit_(visit) {}

  /// `meets`, of their boxes, is 1 or 0, and hard to foresee as all that is asked here: so there is no branch.
  void add_if(int meets, const Run& p, const Run& q) {
    pairs_[count_] = {p.first, p.last, q.first, q.last};
    const int may_meet = static_cast<int>(p.group != q.group) | static_cast<int>(p.group == any_group);
    const int follow = (static_cast<int>(p.last == q.first) & static_cast<int>(q.goes_on())) |
                       (static_cast<int>(q.last == p.first) & static_cast<int>(p.goes_on()));
    count_ += static_cast<std::size_t>(meets & may_meet & (follow ^ 1));
    if (count_ == pairs_.size()) visit();
  }
  /// Every two whose boxes meet.
  void add_all(std::span<const Run> runs) {
    boxes_.assign(runs);
    boxes_.for_each_pair([&](std::size_t i, std::size_t j) {
      const Run &p = runs[i], &q = runs[j];
      add_if(static_cast<int>(p.box.meets(q.box)), p, q);
    });
  }
  void visit() {
    if (count_ > 0) visit_(std::span(pairs_).first(count_));
    count_ = 0;
  }

 private:
  const PairVisitor& visit_;
  CoarseBoxes boxes_;
  std::size_t count_ = 0;
  std::array<RunPair, tuning::pairs_a_batch> pairs_;  // not written before it is used
};

class Finder {
 public:
  Finder(std::span<const Point> points, const PairVisitor& visit, PairGoal goal, const UnsureEdge& unsure)
      : points_(points), visit_(visit), goal_(goal), unsure_(unsure) {}

  void run(LargeArray<Run> runs) {
    if (runs.size() <= leaf_size) {
      PairBatch batch(visit_);
      if (!one_group(runs)) batch.add_all(runs);
      batch.visit();
      return;
    }
    if (CallMemory::current()) {
      split(std::move(runs), Cell{});
      return;
    }
    TaskGroup::run([&](TaskGroup& tasks) { split_in_parallel(std::move(runs), Cell{}, tasks); });
  }

 private:
  struct Task {
    std::size_t begin;
    Cell cell;
  };

  /// The cut for a cell, after going over to clipped edges where boxes say too little; growth is infinite
  /// where every pair is to be tested.
  CellCut choose_cut(LargeArray<Run>& runs, std::size_t begin, Cell& cell, PairBatch& batch) const {
    const auto count = [&] { return runs.size() - begin; };
    if (!cell.clipped) {
      if (count() <= leaf_size) return {};
      const RunParts parts = goal_ == PairGoal::boxes ? RunParts::whole : RunParts::edges;
      const CellCut cut = best_run_cut(tail(runs, begin), parts);
      if (cut.growth <= tuning::box_growth || goal_ == PairGoal::boxes)
        return cut.growth <= tuning::largest_growth ? cut : CellCut{};
      clip_edges(runs, begin, cell);
    }
    while (count() > tuning::clipped_edges_of_one_cell) {
      if (match_crossers(Axis::x, runs, begin, cell, batch) || match_crossers(Axis::y, runs, begin, cell, batch))
        continue;
      const CellCut cut = best_cut(points_, tail(runs, begin), cell.box, unsure_ != nullptr);
      return cut.growth <= tuning::largest_growth ? cut : CellCut{};
    }
    return {};
  }

  /// Runs are divided at a cut, unless it is their boxes that count.
  std::span<const Point> run_points() const { return goal_ == PairGoal::boxes ? std::span<const Point>() : points_; }

  static std::span<Run> tail(LargeArray<Run>& runs, std::size_t begin) { return std::span(runs).subspan(begin); }

  /// Runs to single edges, each with the box of its part in the cell.
  void clip_edges(LargeArray<Run>& runs, std::size_t begin, Cell& cell) const {
    const LargeArray<Run> whole(runs.begin() + static_cast<std::ptrdiff_t>(begin), runs.end());
    runs.resize(begin);
    for (const Run& run : whole) {
      for (std::uint32_t e = run.first; e < run.last; ++e) {
        // Within a run an edge meets none but in the vertex between them.
        const bool goes_on = e > run.first || run.goes_on() != 0;
        Run edge{Box::of(points_[e], points_[e + 1]).widened(run.margin()), e, e + 1, run.group,
                 Run::marks_of(goes_on, run.margin())};
        if (clip_to(cell, edge)) runs.push_back(edge);
      }
    }
    cell.clipped = true;
    Box around = empty_box;
    for (const Run& e : tail(runs, begin)) around = around.joined(e.box);
    cell.box = {std::max(cell.box.x0, around.x0), std::max(cell.box.y0, around.y0), std::min(cell.box.x1, around.x1),
                std::min(cell.box.y1, around.y1)};
  }

  bool clip_to(const Cell& cell, Run& edge) const {
    const auto keep = [&](CutKind kind, double at, bool right) {
      if (at == infinity || at == -infinity) return true;
      const Sides sides = divide_edge(points_, edge, {kind, at, 0, true});
      edge = right ? sides.right_part : sides.left_part;
      return right ? sides.right : sides.left;
    };
    // A meeting on the upper or right side of the cell belongs to the next cell, whose lower or left side it is.
    return keep(CutKind::at_x, cell.box.x0, true) && keep(CutKind::at_x, cell.box.x1, false) &&
           keep(CutKind::at_y, cell.box.y0, true) && keep(CutKind::at_y, cell.box.y1, false);
  }

  /// What of runs[begin..] is left of the cut stays in their place, up to the returned index.
  std::size_t divide_all(LargeArray<Run>& runs, std::size_t begin, const CellCut& cut, const Cell& cell,
                         LargeArray<Run>& right) const {
    if (!cell.clipped) return divide_runs(run_points(), runs, begin, cut, right);
    std::size_t left_end = begin;
    for (std::size_t i = begin; i < runs.size(); ++i) {
      const Run e = runs[i];
      const Sides sides = divide_edge(points_, e, cut);
      if (sides.touches && unsure_) unsure_(e.first);
      if (sides.right) right.push_back(sides.right_part);
      if (sides.left) runs[left_end++] = sides.left_part;
    }
    return left_end;
  }

  void split_in_parallel(LargeArray<Run> runs, Cell cell, TaskGroup& tasks) {
    if (one_group(runs)) return;
    CellCut cut;
    if (runs.size() > runs_of_one_thread) {
      PairBatch batch(visit_);
      cut = choose_cut(runs, 0, cell, batch);
      batch.visit();
    }
    if (cut.growth == infinity) {
      split(std::move(runs), cell);
      return;
    }
    // A task is called as const, so its boxes travel behind a pointer.
    const auto right = std::make_shared<LargeArray<Run>>();
    reserve_in_large_pages(*right, runs.size() * 5 / 8);
    const std::size_t left_end = divide_all(runs, 0, cut, cell, *right);
    runs.resize(left_end);
    // What was right of the cut is there twice else while the left is divided further.
    release_unused_pages(runs);
    const auto [left_cell, right_cell] = cell.halves(cut);
    tasks.add([this, &tasks, right, c = right_cell] { split_in_parallel(std::move(*right), c, tasks); });
    split_in_parallel(std::move(runs), left_cell, tasks);
  }

  /// Depth first, on one array used as a stack: the cell on top owns its tail.
  void split(LargeArray<Run> runs, const Cell& root) {
    PairBatch batch(visit_);
    LargeArray<Run> right;
    Array<Task> stack{{0, root}};
    while (!stack.empty()) {
      poll();
      Task task = stack.back();
      stack.pop_back();
      if (one_group(tail(runs, task.begin))) {
        runs.resize(task.begin);
        continue;
      }
      const CellCut cut = choose_cut(runs, task.begin, task.cell, batch);
      if (cut.growth == infinity) {
        batch.add_all(tail(runs, task.begin));
        runs.resize(task.begin);
        continue;
      }
      right.clear();
      const std::size_t left_end = divide_all(runs, task.begin, cut, task.cell, right);
      runs.resize(left_end);
      runs.insert(runs.end(), right.begin(), right.end());
      const auto [left_cell, right_cell] = task.cell.halves(cut);
      stack.push_back({task.begin, left_cell});
      stack.push_back({left_end, right_cell});
    }
    batch.visit();
  }

  /// Flat edges that go through the cell along an axis meet what their values across it say: sorted by those they are
  /// paired with whatever they reach and are out of the way, while cuts would copy them down to the smallest cells. As
  /// in a segment tree, an edge goes through O(log n) cells when it first goes through one. False, and nothing done,
  /// where such edges are few.
  bool match_crossers(Axis axis, LargeArray<Run>& runs, std::size_t begin, const Cell& cell, PairBatch& batch) const {
    const std::span<Run> all = tail(runs, begin);
    const auto stays = [&](const Run& e) {
      return low(e.box, axis) > low(cell.box, axis) || high(e.box, axis) < high(cell.box, axis) ||
             !is_flat(e, axis, cell.box, all.size());
    };
    const auto staying = static_cast<std::size_t>(std::count_if(all.begin(), all.end(), stays));
    if ((all.size() - staying) * tuning::entries_a_crosser < all.size()) return false;
    std::partition(all.begin(), all.end(), stays);
    const Axis across = axis == Axis::x ? Axis::y : Axis::x;
    const auto before = [&](const Run& p, const Run& q) { return low(p.box, across) < low(q.box, across); };
    const std::span<Run> others = all.first(staying), crossers = all.subspan(staying);
    parallel_sort(others.begin(), others.end(), before);
    parallel_sort(crossers.begin(), crossers.end(), before);
    // Each with those that begin not before it, and before it ends.
    const auto match = [&](const Run& e, std::span<const Run> sorted, PairBatch& found) {
      const double reach = high(e.box, across);
      for (const Run& q : sorted) {
        if (low(q.box, across) > reach) break;
        found.add_if(1, e, q);
      }
    };
    // Crossers from one to another, and the others that begin before them.
    const auto match_range = [&](std::size_t first, std::size_t past, PairBatch& found) {
      const auto begin_other =
          first == 0 ? others.begin() : std::lower_bound(others.begin(), others.end(), crossers[first - 1], before);
      auto other = static_cast<std::size_t>(begin_other - others.begin());
      for (std::size_t crosser = first; crosser < past; ++crosser) {
        for (; other < others.size() && before(others[other], crossers[crosser]); ++other)
          match(others[other], crossers.subspan(crosser), found);
        match(crossers[crosser], others.subspan(other), found);
        match(crossers[crosser], crossers.subspan(crosser + 1), found);
      }
    };
    if (crossers.size() <= tuning::crossers_a_task) {
      match_range(0, crossers.size(), batch);
    } else {
      for_ranges(crossers.size(), tuning::crossers_a_task, [&](std::size_t first, std::size_t past) {
        PairBatch found(visit_);
        match_range(first, past, found);
        found.visit();
      });
    }
    runs.resize(begin + staying);
    return true;
  }

  std::span<const Point> points_;
  const PairVisitor& visit_;
  PairGoal goal_;
  const UnsureEdge& unsure_;
};

}  // namespace

void find_pairs(std::span<const Point> points, LargeArray<Run> runs, const PairVisitor& visit, PairGoal goal,
                const UnsureEdge& unsure) {
  Finder(points, visit, goal, unsure).run(std::move(runs));
}

}  // namespace oblast::internal::noding
