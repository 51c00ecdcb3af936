#include "noding/arrange_cuts.h"

#include <algorithm>
#include <bit>

#include "base/counting_sort.h"
#include "base/index.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "noding/along.h"
#include "noding/monotone_runs.h"

namespace oblast::internal::noding {
namespace {

/// Sorts the contacts of one edge along it, and drops repeated ones. Rounding is monotone, so the order along the edge
/// is the order of x, and of y where x is the same, each in the edge's own direction.
class SortAlong {
 public:
  /// An edge from a to b.
  EdgeContact* operator()(const Point& a, const Point& b, EdgeContact* begin, EdgeContact* end) {
    const Along along(a, b);
    const auto direction = [&](const EdgeContact& p, const EdgeContact& q) { return along(p.at, q.at); };
    if (end - begin <= tuning::few_cuts)
      std::sort(begin, end, direction);
    else
      sort_many(a, b, {begin, end}, direction);
    return drop_repeated(begin, end);
  }

 private:
  /// Into parts of the edge of one length, by counting; then each part. Where cuts are spread evenly a part has but one
  /// or two, and little of this is hard to foresee.
  template <class Direction>
  void sort_many(const Point& a, const Point& b, std::span<EdgeContact> cuts, const Direction& direction) {
    const bool by_x = a.x != b.x;
    const double from = by_x ? a.x : a.y, to = by_x ? b.x : b.y;
    const double parts_a_unit = static_cast<double>(cuts.size() - 1) / (to - from);
    const auto part_of = [&](const EdgeContact& cut) {
      return static_cast<std::uint32_t>(((by_x ? cut.at.x : cut.at.y) - from) * parts_a_unit);
    };
    ends_.resize(cuts.size());
    counting_sort(ends_, sorted_, [&](const auto& visit) {
      for (const EdgeContact& cut : cuts) visit(part_of(cut), cut);
    });
    for (std::size_t part = 0, begin = 0; part < cuts.size(); begin = ends_[part++])
      if (ends_[part] - begin > 1) std::sort(sorted_.begin() + begin, sorted_.begin() + ends_[part], direction);
    std::copy(sorted_.begin(), sorted_.end(), cuts.begin());
  }

  static EdgeContact* drop_repeated(EdgeContact* begin, EdgeContact* end) {
    EdgeContact* last = begin;
    for (EdgeContact* cut = begin + 1; cut != end; ++cut) {
      if (cut->at == last->at)
        last->sine = std::min(last->sine, cut->sine);
      else
        *++last = *cut;
    }
    return last + 1;
  }

  Array<std::uint32_t> ends_;
  LargeArray<EdgeContact> sorted_;
};

/// Drops cuts at which the edge from a to b would turn back in x or y, as it might where cuts are at vertices beside
/// it. What they were to settle is left to the next round. So the pieces' boxes always shrink. Looked at from the
/// smaller end, whichever way the edge runs. REQUIRES: sorted along the edge.
EdgeContact* keep_monotone(const Point& a, const Point& b, EdgeContact* begin, EdgeContact* end) {
  const bool rightward = lexicographically_less(a, b);
  if (!rightward) std::reverse(begin, end);
  const Point& last = rightward ? b : a;
  Point from = rightward ? a : b;
  EdgeContact* kept = begin;
  for (EdgeContact* cut = begin; cut != end; ++cut) {
    if (!Box::of(from, last).contains(cut->at)) continue;
    from = cut->at;
    *kept++ = *cut;
  }
  if (!rightward) std::reverse(begin, kept);
  return kept;
}

/// By ranges of edges, side by side: first each cut to the others of its range, then each range by itself.
class Arrangement {
 public:
  Arrangement(const Strands& strands, Settling settling, Clearance* clearance)
      : strands_(strands), points_(strands.points), settling_(settling), clearance_(clearance) {}

  LargeArray<EdgeCut> run(std::span<const std::span<const EdgeContact>> blocks) {
    std::size_t count = 0;
    for (const auto& block : blocks) count += block.size();
    check_count(count, "cuts");
    edges_a_range_ = std::bit_ceil(grain(points_.size(), count));
    ranges_.resize(range_count(points_.size(), edges_a_range_));
    resize_uninitialized(cuts_, count);
    scatter(blocks);
    for_numbered_ranges(points_.size(), edges_a_range_, [&](std::size_t range, std::size_t first, std::size_t past) {
      ranges_[range].end = arrange(first, past, std::span(cuts_).subspan(ranges_[range].begin, ranges_[range].count()));
    });
    auto last = cuts_.begin();
    for (const Range& range : ranges_) {
      const auto first = cuts_.begin() + range.begin, past = cuts_.begin() + range.end;
      last = last == first ? past : std::copy(first, past, last);
    }
    cuts_.erase(last, cuts_.end());
    return std::move(cuts_);
  }

 private:
  /// Of the cuts of a range of edges: what is left of them, in the end.
  struct Range {
    std::uint32_t begin = 0, end = 0;

    std::uint32_t count() const { return end - begin; }
  };

  void scatter(std::span<const std::span<const EdgeContact>> blocks) {
    const auto range_of = [&, bits = std::countr_zero(edges_a_range_)](const EdgeContact& cut) {
      return cut.edge >> bits;
    };
    const std::size_t blocks_a_task = range_count(blocks.size(), tuning::cut_tasks), count = ranges_.size();
    const std::size_t tasks = range_count(blocks.size(), blocks_a_task);
    Array<std::uint32_t> places(tasks * count);  // by task and range: how many; then where the next one goes
    for_numbered_ranges(blocks.size(), blocks_a_task, [&](std::size_t task, std::size_t first, std::size_t past) {
      std::uint32_t* const counts = &places[task * count];
      for (; first < past; ++first)
        for (const EdgeContact& cut : blocks[first]) ++counts[range_of(cut)];
    });
    begins_of_ranges(tasks, count, [&](std::size_t task) { return &places[task * count]; });
    for (std::size_t range = 0; range < count; ++range) {
      ranges_[range].begin = places[range];
      ranges_[range].end = range + 1 < count ? places[range + 1] : static_cast<std::uint32_t>(cuts_.size());
    }
    for_numbered_ranges(blocks.size(), blocks_a_task, [&](std::size_t task, std::size_t first, std::size_t past) {
      std::uint32_t* const next = &places[task * count];
      for (; first < past; ++first)
        for (const EdgeContact& cut : blocks[first]) cuts_[next[range_of(cut)]++] = cut;
    });
  }

  /// Of the edges [first, past). What is left of the cuts is at their beginning, up to the returned index of all.
  std::uint32_t arrange(std::size_t first, std::size_t past, std::span<EdgeContact> cuts) const {
    EdgeContact* packed = cuts.data();
    if (cuts.empty()) return static_cast<std::uint32_t>(packed - cuts_.data());
    Array<std::uint32_t> ends(past - first);  // by edge: of its cuts
    Array<EdgeContact> by_edge;
    counting_sort(ends, by_edge, [&](const auto& visit) {
      for (const EdgeContact& cut : cuts) visit(cut.edge - first, cut);
    });
    SortAlong sort_along;
    std::size_t strand = strands_.strand_of(static_cast<std::uint32_t>(first));
    for (EdgeContact *begin = by_edge.data(), *const last = begin + by_edge.size(); begin != last;) {
      const std::uint32_t e = begin->edge;
      EdgeContact* const end = by_edge.data() + ends[e - first];
      const Point &a = points_[e], &b = points_[e + 1];
      EdgeContact* kept = sort_along(a, b, begin, end);
      if (settling_.tolerance > 0) kept = keep_monotone(a, b, begin, kept);
      if (clearance_) {
        while (strands_.ends[strand] <= e) ++strand;
        clearance_->look_along(strand, {begin, kept});
        kept = std::remove_if(begin, kept, [&](const EdgeContact& contact) { return contact.is_common_end(a, b); });
      }
      packed = std::copy(begin, kept, packed);
      begin = end;
    }
    return static_cast<std::uint32_t>(packed - cuts_.data());
  }

  const Strands& strands_;
  const LargeArray<Point>& points_;
  Settling settling_;
  Clearance* clearance_;
  std::size_t edges_a_range_ = 0;  ///< a power of two
  Array<Range> ranges_;
  LargeArray<EdgeContact> cuts_;
};

}  // namespace

LargeArray<EdgeCut> arrange_cuts(const Strands& strands, std::span<const std::span<const EdgeContact>> blocks,
                                 Settling settling, Clearance* clearance) {
  return Arrangement(strands, settling, clearance).run(blocks);
}

}  // namespace oblast::internal::noding
