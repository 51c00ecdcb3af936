#include "noding/pair_finder.h"

#include <tbb/task_group.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "noding/cell_cut.h"

namespace oblast::noding {
namespace {

// A sweep over so many boxes costs less than what cutting them further would copy; clipped edges, which lie close, are
// cut further.
constexpr std::size_t leaf_size = runs_of_one_cell;
constexpr std::size_t clipped_leaf_size = 32;
constexpr std::size_t batch_size = 1024;
// Cells below this size, or with a cut better than this growth, are content with boxes.
constexpr std::size_t bundle_size = 512;
constexpr double box_growth = 1.2;
// A cut that copies more than this is no progress: everything meets nearly everything.
constexpr double largest_growth = 1.8;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The part of the plane that entries are looked at in; its bounds matter until edges are clipped to it.
struct Cell {
  double x0 = -infinity, y0 = -infinity, x1 = infinity, y1 = infinity;
  bool clipped = false;

  std::pair<Cell, Cell> halves(const CellCut& cut) const {
    Cell left = *this, right = *this;
    if (!clipped) {
      (cut.kind == CutKind::at_x ? left.x1 : left.y1) = cut.at;
      (cut.kind == CutKind::at_x ? right.x0 : right.y0) = cut.at;
    }
    return {left, right};
  }
};

bool one_group(std::span<const Entry> entries) {
  if (entries.empty()) return true;
  const Group group = entries[0].group;
  if (group == any_group) return false;
  return std::all_of(entries.begin(), entries.end(), [&](const Entry& e) { return e.group == group; });
}

class Finder {
 public:
  Finder(std::span<const Point> points, const PairVisitor& visit, PairGoal goal, const Nearness& nearness)
      : points_(points), visit_(visit), goal_(goal), nearness_(nearness) {}

  void run(std::vector<Run> runs) {
    if (runs.size() <= runs_of_one_thread) {
      if (!one_group(runs)) split(std::move(runs), Cell{});
      return;
    }
    tbb::task_group tasks;
    split_in_parallel(std::move(runs), Cell{}, tasks);
    tasks.wait();
  }

 private:
  struct Task {
    std::size_t begin;
    Cell cell;
  };

  /// The cut for a cell, after going over to clipped edges where boxes say too little; growth is infinite
  /// where every pair is to be tested.
  CellCut choose_cut(std::vector<Entry>& entries, std::size_t begin, Cell& cell) {
    if (entries.size() - begin <= (cell.clipped ? clipped_leaf_size : leaf_size)) return {};
    CellCut cut;
    if (!cell.clipped) {
      cut = best_axis_cut(tail(entries, begin), nearness_.margin);
      if (cut.growth <= box_growth || entries.size() - begin <= bundle_size || goal_ == PairGoal::boxes)
        return cut.growth <= largest_growth ? cut : CellCut{};
      clip_edges(entries, begin, cell);
    }
    cut = best_cut(points_, tail(entries, begin), nearness_.margin);
    return cut.growth <= largest_growth ? cut : CellCut{};
  }

  static std::span<Entry> tail(std::vector<Entry>& entries, std::size_t begin) {
    return std::span(entries).subspan(begin);
  }

  /// Runs to single edges, each with the box of its part in the cell.
  void clip_edges(std::vector<Entry>& entries, std::size_t begin, Cell& cell) {
    const std::vector<Entry> runs(entries.begin() + static_cast<std::ptrdiff_t>(begin), entries.end());
    entries.resize(begin);
    for (const Entry& run : runs) {
      for (std::uint32_t e = run.first; e < run.last; ++e) {
        Entry edge{Box::of(points_[e], points_[e + 1]), e, e + 1, run.group};
        if (clip_to(cell, edge)) entries.push_back(edge);
      }
    }
    cell.clipped = true;
  }

  bool clip_to(const Cell& cell, Entry& edge) const {
    const auto keep = [&](CutKind kind, double at, bool right) {
      if (at == infinity || at == -infinity) return true;
      const Sides sides = divide_edge(points_, edge, {kind, at, 0, nearness_.margin, true});
      edge.box = right ? sides.right_box : sides.left_box;
      return right ? sides.right : sides.left;
    };
    // A meeting on the upper or right side of the cell belongs to the next cell, whose lower or left side it is.
    return keep(CutKind::at_x, cell.x0, true) && keep(CutKind::at_x, cell.x1, false) &&
           keep(CutKind::at_y, cell.y0, true) && keep(CutKind::at_y, cell.y1, false);
  }

  Sides divide(const Entry& entry, const CellCut& cut, const Cell& cell) const {
    if (!cell.clipped) return divide_box(entry, cut);
    const Sides sides = divide_edge(points_, entry, cut);
    if (sides.touches && nearness_.unsure) nearness_.unsure(entry.first);
    return sides;
  }

  void split_in_parallel(std::vector<Entry> entries, Cell cell, tbb::task_group& tasks) {
    if (one_group(entries)) return;
    const CellCut cut = entries.size() <= runs_of_one_thread ? CellCut{} : choose_cut(entries, 0, cell);
    if (cut.growth == infinity) {
      split(std::move(entries), cell);
      return;
    }
    // A task is called as const, so its boxes travel behind a pointer.
    const auto left = std::make_shared<std::vector<Entry>>();
    std::vector<Entry> right;
    left->reserve(entries.size() * 5 / 8);
    right.reserve(entries.size() * 5 / 8);
    for (const Entry& e : entries) {
      const Sides sides = divide(e, cut, cell);
      if (sides.left) left->push_back({sides.left_box, e.first, e.last, e.group});
      if (sides.right) right.push_back({sides.right_box, e.first, e.last, e.group});
    }
    entries = {};
    const auto [left_cell, right_cell] = cell.halves(cut);
    tasks.run([this, &tasks, left, c = left_cell] { split_in_parallel(std::move(*left), c, tasks); });
    split_in_parallel(std::move(right), right_cell, tasks);
  }

  /// Depth first, on one array used as a stack: the cell on top owns its tail.
  void split(std::vector<Entry> entries, const Cell& root) {
    std::vector<RunPair> batch;
    std::vector<Entry> right;
    std::vector<Task> stack{{0, root}};
    while (!stack.empty()) {
      Task task = stack.back();
      stack.pop_back();
      if (one_group(tail(entries, task.begin))) {
        entries.resize(task.begin);
        continue;
      }
      const CellCut cut = choose_cut(entries, task.begin, task.cell);
      if (cut.growth == infinity) {
        test_all(tail(entries, task.begin), batch);
        entries.resize(task.begin);
        continue;
      }
      right.clear();
      std::size_t left_end = task.begin;
      for (std::size_t i = task.begin; i < entries.size(); ++i) {
        const Entry e = entries[i];
        const Sides sides = divide(e, cut, task.cell);
        if (sides.right) right.push_back({sides.right_box, e.first, e.last, e.group});
        if (sides.left) entries[left_end++] = {sides.left_box, e.first, e.last, e.group};
      }
      entries.resize(left_end);
      entries.insert(entries.end(), right.begin(), right.end());
      const auto [left_cell, right_cell] = task.cell.halves(cut);
      stack.push_back({task.begin, left_cell});
      stack.push_back({left_end, right_cell});
    }
    if (!batch.empty()) visit_(batch);
  }

  /// Tests every pair of a cell by a sweep along the axis on which the boxes spread more: of each box only those that
  /// begin before its end need a look.
  void test_all(std::span<Entry> entries, std::vector<RunPair>& batch) const {
    double x_low = infinity, x_high = -infinity, y_low = infinity, y_high = -infinity, x_sum = 0, y_sum = 0;
    for (const Entry& e : entries) {
      x_low = std::min(x_low, e.box.x0);
      x_high = std::max(x_high, e.box.x1);
      y_low = std::min(y_low, e.box.y0);
      y_high = std::max(y_high, e.box.y1);
      x_sum += e.box.x1 - e.box.x0;
      y_sum += e.box.y1 - e.box.y0;
    }
    if (x_sum * (y_high - y_low) <= y_sum * (x_high - x_low))
      sweep<&Box::x0, &Box::x1, &Box::y0, &Box::y1>(entries, batch);
    else
      sweep<&Box::y0, &Box::y1, &Box::x0, &Box::x1>(entries, batch);
  }

  template <double Box::*begin, double Box::*end, double Box::*low, double Box::*high>
  void sweep(std::span<Entry> entries, std::vector<RunPair>& batch) const {
    const double margin = nearness_.margin;
    std::sort(entries.begin(), entries.end(),
              [](const Entry& p, const Entry& q) { return p.box.*begin < q.box.*begin; });
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const Entry& p = entries[i];
      const double reach = p.box.*end + margin, lowest = p.box.*low - margin, highest = p.box.*high + margin;
      for (std::size_t j = i + 1; j < entries.size() && entries[j].box.*begin <= reach; ++j) {
        const Entry& q = entries[j];
        if (q.box.*high < lowest || q.box.*low > highest) continue;
        if (p.group == q.group && p.group != any_group) continue;
        batch.push_back({p.first, p.last, q.first, q.last});
      }
      if (batch.size() >= batch_size) {
        visit_(batch);
        batch.clear();
      }
    }
  }

  std::span<const Point> points_;
  const PairVisitor& visit_;
  PairGoal goal_;
  const Nearness& nearness_;
};

}  // namespace

void find_pairs(std::span<const Point> points, std::vector<Run> runs, const PairVisitor& visit, PairGoal goal,
                const Nearness& nearness) {
  Finder(points, visit, goal, nearness).run(std::move(runs));
}

}  // namespace oblast::noding
