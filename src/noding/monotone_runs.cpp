#include "noding/monotone_runs.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "base/index.h"
#include "base/large_pages.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "plane/largest_ulp.h"

namespace oblast::internal::noding {
namespace {

constexpr Group settled_group = 1;

/// Right and left, or up and down.
bool turns_back(unsigned headings) { return (headings & headings >> 2 & 0b0011) != 0; }

/// From u to v and on to w, in x or in y.
bool goes_on(const Point& u, const Point& v, const Point& w, double margin) {
  const auto along = [margin](double from, double at, double to) {
    return static_cast<int>(std::min(from, to) < at - margin) & static_cast<int>(std::max(from, to) > at + margin);
  };
  return (along(u.x, v.x, w.x) | along(u.y, v.y, w.y)) != 0;
}

/// Where a run begins is a bit, by edge. Where they begin is hard to foresee, so it is found without branches, and the
/// runs are made once they are counted.
using Begins = Array<std::uint64_t>;
constexpr std::size_t edges_a_word = 64;

/// The margin of a run with this box.
double margin_of(const Box& box, double ulps) {
  return ulps * ulp_of(std::max(std::max(std::fabs(box.x0), std::fabs(box.x1)),
                                std::max(std::fabs(box.y0), std::fabs(box.y1))));
}

class RunFinder {
 public:
  RunFinder(const Strands& strands, Grouping grouping, const RunMargins& margins)
      : strands_(strands),
        points_(strands.points.data()),
        grouping_(grouping),
        margins_(margins),
        begins_(range_count(strands.points.size(), edges_a_word)) {}

  /// Of those of the edges [begin, end), whole words of them, how many there are. A run that goes on behind them is
  /// parted there.
  std::size_t look(std::size_t begin, std::size_t end) {
    auto first = static_cast<std::uint32_t>(begin);
    for (std::size_t s = strands_.strand_of(first); s < strands_.size() && strands_.begin(s) < end; ++s) {
      first = std::max(first, strands_.begin(s));
      const std::uint32_t past = std::min(strands_.ends[s] - 1, static_cast<std::uint32_t>(end));
      if (first >= past) continue;
      if (grouping_ == Grouping::by_moved)
        look_in<true>(first, past);
      else
        look_in<false>(first, past);
    }
    std::size_t count = 0;
    for (std::size_t w = begin / edges_a_word; w * edges_a_word < end; ++w)
      count += static_cast<std::size_t>(std::popcount(begins_[w]));
    return count;
  }

  /// Writes the runs of the edges [begin, end) once they were looked at.
  void write(std::size_t begin, std::size_t end, Run* to) const {
    std::size_t strand = strands_.strand_of(static_cast<std::uint32_t>(begin));
    std::uint32_t first = none;
    const auto add = [&](std::size_t past) {
      *to++ = run(strand, first, std::min(strands_.ends[strand] - 1, static_cast<std::uint32_t>(past)));
    };
    for (std::size_t w = begin / edges_a_word; w * edges_a_word < end; ++w) {
      for (std::uint64_t word = begins_[w]; word != 0; word &= word - 1) {
        const auto next = static_cast<std::uint32_t>(w * edges_a_word + std::countr_zero(word));
        if (first != none) add(next);
        first = next;
        while (strands_.ends[strand] <= first) ++strand;
      }
    }
    if (first != none) add(end);
  }

 private:
  bool piece_moved(std::uint32_t edge) const { return (strands_.flags[edge] & moved_flag) != 0; }
  /// Of the flags by which runs are parted: whether the last round made the piece, and an identical one before it.
  std::uint8_t kind(std::uint32_t edge) const { return strands_.flags[edge] & (moved_flag | repeated_flag); }

  /// Of the edges [first, past) of a strand, not none.
  template <bool by_moved>
  void look_in(std::uint32_t first, std::uint32_t past) {
    unsigned headings = heading(points_[first], points_[first + 1]);
    std::uint32_t run_begin = first;
    std::uint64_t word = std::uint64_t{1} << first % edges_a_word;
    for (std::uint32_t edge = first + 1; edge < past; ++edge) {
      if (edge % edges_a_word == 0) {
        begins_[edge / edges_a_word - 1] |= word;
        word = 0;
      }
      const unsigned next = heading(points_[edge], points_[edge + 1]);
      bool begins_here =
          static_cast<int>(turns_back(headings | next)) | static_cast<int>(edge - run_begin == longest_run);
      if (by_moved) begins_here = begins_here || kind(edge) != kind(run_begin);
      word |= static_cast<std::uint64_t>(begins_here) << edge % edges_a_word;
      headings = begins_here ? next : headings | next;
      run_begin = begins_here ? edge : run_begin;
    }
    begins_[(past - 1) / edges_a_word] |= word;
  }

  Run run(std::size_t strand, std::uint32_t first, std::uint32_t last) const {
    Group group = any_group;
    if (grouping_ == Grouping::by_moved)
      group = piece_moved(first) ? any_group : settled_group;
    else if (grouping_ == Grouping::by_strand && strands_.simplicity[strand] == Simplicity::known)
      group = strands_.group[strand];
    const bool on = first > strands_.begin(strand) &&
                    goes_on(points_[first - 1], points_[first], points_[first + 1], margins_.vertex);
    const Box box = Box::of(points_[first], points_[last]);
    if (margins_.ulps == 0) return {box, first, last, group, on};
    const double margin = margin_of(box, margins_.ulps);
    return {box.widened(margin), first, last, group, Run::marks_of(on, margin)};
  }

  const Strands& strands_;
  const Point* points_;
  Grouping grouping_;
  RunMargins margins_;
  Begins begins_;
};

}  // namespace

LargeArray<Run> monotone_runs(const Strands& strands, Grouping grouping, const RunMargins& margins) {
  constexpr std::size_t edges_a_range = tuning::run_words_a_range * edges_a_word;
  RunFinder finder(strands, grouping, margins);
  const std::size_t edges = strands.points.size();
  Array<std::size_t> places(range_count(edges, edges_a_range) + 1);
  for_numbered_ranges(edges, edges_a_range, [&](std::size_t i, std::size_t begin, std::size_t end) {
    places[i + 1] = finder.look(begin, end);
  });
  std::partial_sum(places.begin(), places.end(), places.begin());
  LargeArray<Run> runs;
  resize_uninitialized(runs, places.back());
  for_numbered_ranges(edges, edges_a_range, [&](std::size_t i, std::size_t begin, std::size_t end) {
    finder.write(begin, end, runs.data() + places[i]);
  });
  if (grouping == Grouping::by_moved)
    std::erase_if(runs, [&](const Run& run) { return (strands.flags[run.first] & repeated_flag) != 0; });
  return runs;
}

}  // namespace oblast::internal::noding
