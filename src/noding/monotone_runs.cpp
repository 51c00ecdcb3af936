#include "noding/monotone_runs.h"

#include <numeric>

#include "memory/large_pages.h"
#include "parallel/for_ranges.h"

namespace oblast::noding {
namespace {

constexpr Group settled_group = 1;

/// Right and left, or up and down.
bool turns_back(unsigned headings) { return (headings & headings >> 1 & 0b0101) != 0; }

class RunFinder {
 public:
  RunFinder(const Strands& strands, Grouping grouping) : strands_(strands), grouping_(grouping) {}

  /// Calls add(run) for those of the edges [begin, end). A run that goes on behind them is parted there.
  template <class Add>
  void find(std::size_t begin, std::size_t end, const Add& add) const {
    auto first = static_cast<std::uint32_t>(begin);
    for (std::size_t s = strands_.strand_of(first); s < strands_.size() && strands_.begin(s) < end; ++s) {
      first = std::max(first, strands_.begin(s));
      find_in(s, first, std::min(strands_.ends[s] - 1, static_cast<std::uint32_t>(end)), add);
    }
  }

 private:
  bool piece_moved(std::uint32_t edge) const { return (strands_.flags[edge] & moved_flag) != 0; }

  /// Of the edges [first, past) of a strand.
  template <class Add>
  void find_in(std::size_t strand, std::uint32_t first, std::uint32_t past, const Add& add) const {
    const Array<Point>& points = strands_.points;
    const bool by_moved = grouping_ == Grouping::by_moved;
    const bool grouped = grouping_ == Grouping::by_strand && strands_.simplicity[strand] == Simplicity::known;
    const Group group = grouped ? strands_.group[strand] : any_group;
    while (first < past) {
      const std::uint32_t longest = std::min(first + longest_run, past);
      const bool moved = by_moved && piece_moved(first);
      unsigned headings = heading(points[first], points[first + 1]);
      std::uint32_t last = first + 1;
      for (; last < longest; ++last) {
        headings |= heading(points[last], points[last + 1]);
        if (turns_back(headings) || (by_moved && piece_moved(last) != moved)) break;
      }
      const Group of_run = by_moved ? (moved ? any_group : settled_group) : group;
      add(Run{Box::of(points[first], points[last]), first, last, of_run});
      first = last;
    }
  }

  const Strands& strands_;
  Grouping grouping_;
};

}  // namespace

LargeArray<Run> monotone_runs(const Strands& strands, Grouping grouping) {
  constexpr std::size_t edges_a_range = 1 << 16;
  const RunFinder finder(strands, grouping);
  const std::size_t edges = strands.points.size();
  LargeArray<Run> runs;
  if (edges <= edges_a_range) {
    runs.reserve(edges / 2 + 16);
    finder.find(0, edges, [&](const Run& run) { runs.push_back(run); });
    return runs;
  }
  // Counted first, so that each is put where it belongs: to look twice costs less than to have them twice.
  Array<std::size_t> begins(range_count(edges, edges_a_range) + 1);
  for_numbered_ranges(edges, edges_a_range, [&](std::size_t i, std::size_t begin, std::size_t end) {
    std::size_t count = 0;
    finder.find(begin, end, [&](const Run&) { ++count; });
    begins[i + 1] = count;
  });
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  resize_in_large_pages(runs, begins.back());
  for_numbered_ranges(edges, edges_a_range, [&](std::size_t i, std::size_t begin, std::size_t end) {
    Run* to = runs.data() + begins[i];
    finder.find(begin, end, [&](const Run& run) { *to++ = run; });
  });
  return runs;
}

}  // namespace oblast::noding
