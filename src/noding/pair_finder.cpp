#include "noding/pair_finder.h"

#include <tbb/task_group.h>

#include <algorithm>
#include <limits>
#include <memory>

namespace oblast::noding {
namespace {

constexpr std::size_t leaf_size = 32;
constexpr std::size_t sample_size = 31;
constexpr std::size_t batch_size = 1024;
constexpr std::size_t parallel_size = 20000;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A run's box with what the search needs of it; two to a cache line and a half.
struct Entry {
  Box box;
  std::uint32_t run;
  Group group;
};

/// Half-open cell: its lower and left sides belong to it.
struct Cell {
  double x0 = -infinity, y0 = -infinity, x1 = infinity, y1 = infinity;

  bool holds(double x, double y) const { return x0 <= x && x < x1 && y0 <= y && y < y1; }
};

enum class Axis { x, y };

struct Cut {
  Axis axis = Axis::x;
  double at = 0;
  double growth = infinity;  ///< boxes in both halves over boxes in the cell, by the sample
};

double low(const Box& box, Axis axis) { return axis == Axis::x ? box.x0 : box.y0; }
double high(const Box& box, Axis axis) { return axis == Axis::x ? box.x1 : box.y1; }

/// The median cut of one axis, judged on an evenly spaced sample.
Cut median_cut(std::span<const Entry> entries, Axis axis) {
  double middles[sample_size];
  const Entry* sample[sample_size];
  const std::size_t step = entries.size() / sample_size;
  for (std::size_t i = 0; i < sample_size; ++i) {
    sample[i] = &entries[i * step + step / 2];
    middles[i] = low(sample[i]->box, axis) / 2 + high(sample[i]->box, axis) / 2;
  }
  std::nth_element(middles, middles + sample_size / 2, middles + sample_size);
  Cut cut{axis, middles[sample_size / 2], 0};
  int left = 0, right = 0;
  for (const Entry* e : sample) {
    left += low(e->box, axis) < cut.at;
    right += high(e->box, axis) >= cut.at;
  }
  constexpr int most = static_cast<int>(sample_size) * 7 / 8;
  if (left > most || right > most)
    cut.growth = infinity;
  else
    cut.growth = static_cast<double>(left + right) / static_cast<double>(sample_size);
  return cut;
}

class Finder {
 public:
  Finder(std::span<const Run> runs, const PairVisitor& visit) : runs_(runs), visit_(visit) {}

  void run() {
    std::vector<Entry> entries;
    entries.reserve(runs_.size());
    for (std::uint32_t i = 0; i < runs_.size(); ++i) entries.push_back({runs_[i].box, i, runs_[i].group});
    tbb::task_group tasks;
    split_in_parallel(std::move(entries), Cell{}, tasks);
    tasks.wait();
  }

 private:
  struct Task {
    std::size_t begin;
    Cell cell;
  };

  static bool one_group(std::span<const Entry> entries) {
    if (entries.empty()) return true;
    const Group group = entries[0].group;
    if (group == any_group) return false;
    return std::all_of(entries.begin(), entries.end(), [&](const Entry& e) { return e.group == group; });
  }

  static bool choose_cut(std::span<const Entry> entries, Cut& cut) {
    if (entries.size() <= leaf_size) return false;
    cut = median_cut(entries, Axis::x);
    const Cut other = median_cut(entries, Axis::y);
    if (other.growth < cut.growth) cut = other;
    return cut.growth < 1.7;
  }

  static std::pair<Cell, Cell> halves(const Cell& cell, const Cut& cut) {
    Cell left = cell, right = cell;
    (cut.axis == Axis::x ? left.x1 : left.y1) = cut.at;
    (cut.axis == Axis::x ? right.x0 : right.y0) = cut.at;
    return {left, right};
  }

  void split_in_parallel(std::vector<Entry> entries, const Cell& cell, tbb::task_group& tasks) {
    Cut cut;
    if (one_group(entries)) return;
    if (entries.size() < parallel_size || !choose_cut(entries, cut)) {
      split(std::move(entries), cell);
      return;
    }
    std::vector<Entry> left, right;
    left.reserve(entries.size() * 5 / 8);
    right.reserve(entries.size() * 5 / 8);
    for (const Entry& e : entries) {
      if (low(e.box, cut.axis) < cut.at) left.push_back(e);
      if (high(e.box, cut.axis) >= cut.at) right.push_back(e);
    }
    entries = {};
    const auto [left_cell, right_cell] = halves(cell, cut);
    // A task is called as const, so its boxes travel behind a pointer.
    const auto part = std::make_shared<std::vector<Entry>>(std::move(left));
    tasks.run([this, &tasks, part, part_cell = left_cell] { split_in_parallel(std::move(*part), part_cell, tasks); });
    split_in_parallel(std::move(right), right_cell, tasks);
  }

  /// Depth first, on one array used as a stack: the cell on top owns its tail.
  void split(std::vector<Entry> entries, const Cell& root) {
    std::vector<RunPair> batch;
    batch.reserve(batch_size * 2);
    std::vector<Task> stack{{0, root}};
    while (!stack.empty()) {
      const Task task = stack.back();
      stack.pop_back();
      const std::span<Entry> all = std::span(entries).subspan(task.begin);
      Cut cut;
      if (one_group(all)) {
        entries.resize(task.begin);
      } else if (!choose_cut(all, cut)) {
        test_all(all, task.cell, batch);
        entries.resize(task.begin);
      } else {
        // [left only | straddling | right only], then the straddling ones again for the right half.
        const auto straddling =
            std::partition(all.begin(), all.end(), [&](const Entry& e) { return high(e.box, cut.axis) < cut.at; });
        const auto right =
            std::partition(straddling, all.end(), [&](const Entry& e) { return low(e.box, cut.axis) < cut.at; });
        const std::size_t right_begin = task.begin + static_cast<std::size_t>(right - all.begin());
        const std::size_t copies = static_cast<std::size_t>(right - straddling);
        const std::size_t straddling_begin = right_begin - copies;
        const std::size_t old_size = entries.size();
        entries.resize(old_size + copies);
        std::copy_n(entries.begin() + static_cast<std::ptrdiff_t>(straddling_begin), copies,
                    entries.begin() + static_cast<std::ptrdiff_t>(old_size));
        const auto [left_cell, right_cell] = halves(task.cell, cut);
        stack.push_back({task.begin, left_cell});
        stack.push_back({right_begin, right_cell});
      }
    }
    if (!batch.empty()) visit_(batch);
  }

  void test_all(std::span<const Entry> entries, const Cell& cell, std::vector<RunPair>& batch) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const Entry& p = entries[i];
      for (std::size_t j = i + 1; j < entries.size(); ++j) {
        const Entry& q = entries[j];
        if (!p.box.meets(q.box)) continue;
        if (p.group == q.group && p.group != any_group) continue;
        if (!cell.holds(std::max(p.box.x0, q.box.x0), std::max(p.box.y0, q.box.y0))) continue;
        batch.emplace_back(p.run, q.run);
      }
      if (batch.size() >= batch_size) {
        visit_(batch);
        batch.clear();
      }
    }
  }

  std::span<const Run> runs_;
  const PairVisitor& visit_;
};

}  // namespace

void find_pairs(std::span<const Run> runs, const PairVisitor& visit) { Finder(runs, visit).run(); }

}  // namespace oblast::noding
