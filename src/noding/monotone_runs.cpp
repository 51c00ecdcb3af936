#include "noding/monotone_runs.h"

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

  /// Of the edges [begin, end). A run that goes on behind them is parted there.
  Array<Run> find(std::size_t begin, std::size_t end) const {
    Array<Run> runs;
    reserve_in_large_pages(runs, (end - begin) / 2 + 16);
    auto first = static_cast<std::uint32_t>(begin);
    for (std::size_t s = strands_.strand_of(first); s < strands_.size() && strands_.begin(s) < end; ++s) {
      first = std::max(first, strands_.begin(s));
      add_runs(s, first, std::min(strands_.ends[s] - 1, static_cast<std::uint32_t>(end)), runs);
    }
    return runs;
  }

 private:
  bool piece_moved(std::uint32_t edge) const { return (strands_.flags[edge] & moved_flag) != 0; }

  /// Of the edges [first, past) of a strand.
  void add_runs(std::size_t strand, std::uint32_t first, std::uint32_t past, Array<Run>& runs) const {
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
      runs.push_back({Box::of(points[first], points[last]), first, last, of_run});
      first = last;
    }
  }

  const Strands& strands_;
  Grouping grouping_;
};

}  // namespace

Array<Run> monotone_runs(const Strands& strands, Grouping grouping) {
  constexpr std::size_t edges_a_range = 1 << 18;  // whose runs fill large pages
  const RunFinder finder(strands, grouping);
  const std::size_t edges = strands.points.size();
  if (edges <= edges_a_range) return finder.find(0, edges);
  Array<Array<Run>> found(range_count(edges, edges_a_range));
  for_numbered_ranges(edges, edges_a_range,
                      [&](std::size_t i, std::size_t begin, std::size_t end) { found[i] = finder.find(begin, end); });
  Array<std::size_t> begins(found.size() + 1);
  for (std::size_t i = 0; i < found.size(); ++i) begins[i + 1] = begins[i] + found[i].size();
  Array<Run> runs;
  resize_in_large_pages(runs, begins.back());
  for_ranges(found.size(), 1, [&](std::size_t i, std::size_t past) {
    for (; i < past; ++i) {
      std::copy(found[i].begin(), found[i].end(), runs.begin() + static_cast<std::ptrdiff_t>(begins[i]));
      found[i] = {};
    }
  });
  return runs;
}

}  // namespace oblast::noding
