#include "noding/monotone_runs.h"

#include <array>
#include <numeric>

#include "memory/large_pages.h"
#include "parallel/for_ranges.h"

namespace oblast::noding {
namespace {

constexpr Group settled_group = 1;

/// Right and left, or up and down.
bool turns_back(unsigned headings) { return (headings & headings >> 2 & 0b0011) != 0; }

/// From u to v and on to w, in x or in y.
bool gets_on(const Point& u, const Point& v, const Point& w, double margin) {
  const auto along = [margin](double from, double at, double to) {
    return static_cast<int>(std::min(from, to) < at - margin) & static_cast<int>(std::max(from, to) > at + margin);
  };
  return (along(u.x, v.x, w.x) | along(u.y, v.y, w.y)) != 0;
}

class RunFinder {
 public:
  RunFinder(const Strands& strands, Grouping grouping, double margin)
      : strands_(strands), points_(strands.points.data()), grouping_(grouping), margin_(margin) {}

  /// Calls add(run) for those of the edges [begin, end). A run that goes on behind them is parted there.
  template <class Add>
  void find(std::size_t begin, std::size_t end, const Add& add) const {
    auto first = static_cast<std::uint32_t>(begin);
    for (std::size_t s = strands_.strand_of(first); s < strands_.size() && strands_.begin(s) < end; ++s) {
      first = std::max(first, strands_.begin(s));
      const std::uint32_t past = std::min(strands_.ends[s] - 1, static_cast<std::uint32_t>(end));
      if (grouping_ == Grouping::by_moved)
        find_in<true>(s, first, past, add);
      else
        find_in<false>(s, first, past, add);
    }
  }

 private:
  bool piece_moved(std::uint32_t edge) const { return (strands_.flags[edge] & moved_flag) != 0; }

  /// Of the edges [first, past) of a strand. Where runs end is hard to foresee, so a block of edges is looked through
  /// first, without branches.
  template <bool by_moved, class Add>
  void find_in(std::size_t strand, std::uint32_t first, std::uint32_t past, const Add& add) const {
    if (first >= past) return;
    const bool grouped = grouping_ == Grouping::by_strand && strands_.simplicity[strand] == Simplicity::known;
    const Group group = grouped ? strands_.group[strand] : any_group;
    const std::uint32_t begin = strands_.begin(strand);
    const auto add_run = [&](std::uint32_t last) {
      const Group of_run = by_moved ? (piece_moved(first) ? any_group : settled_group) : group;
      const bool on = first > begin && gets_on(points_[first - 1], points_[first], points_[first + 1], margin_);
      add(Run{Box::of(points_[first], points_[last]), first, last, of_run, on});
      first = last;
    };
    constexpr std::uint32_t edges_a_block = 128;
    std::array<std::uint32_t, edges_a_block> ends;
    unsigned headings = 0;
    std::uint32_t run_begin = first;
    for (std::uint32_t edge = first; edge < past;) {
      std::size_t count = 0;
      for (const std::uint32_t block_end = std::min(edge + edges_a_block, past); edge < block_end; ++edge) {
        const unsigned next = heading(points_[edge], points_[edge + 1]);
        bool ends_here =
            static_cast<int>(turns_back(headings | next)) | static_cast<int>(edge - run_begin == longest_run);
        if (by_moved) ends_here = ends_here || (edge > run_begin && piece_moved(edge) != piece_moved(run_begin));
        ends[count] = edge;
        count += static_cast<std::size_t>(ends_here);
        headings = ends_here ? next : headings | next;
        run_begin = ends_here ? edge : run_begin;
      }
      for (std::size_t i = 0; i < count; ++i) add_run(ends[i]);
    }
    add_run(past);
  }

  const Strands& strands_;
  const Point* points_;
  Grouping grouping_;
  double margin_;
};

}  // namespace

LargeArray<Run> monotone_runs(const Strands& strands, Grouping grouping, double margin) {
  constexpr std::size_t edges_a_range = 1 << 16;
  const RunFinder finder(strands, grouping, margin);
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
