#include "graph/stops.h"

#include <algorithm>
#include <array>

#include "base/parallel.h"
#include "base/tuning.h"

namespace oblast::internal {
namespace {

using noding::Strands;

/// By ranges of vertices: first what each has, then where to put it is known.
class StopFinder {
 public:
  explicit StopFinder(const Strands& strands)
      : strands_(strands), ranges_(range_count(strands.points.size(), tuning::stop_vertices_a_range) + 1) {}

  /// Without nodes and chains.
  Stops run() {
    for_numbered_ranges(
        strands_.points.size(), tuning::stop_vertices_a_range,
        [&](std::size_t i, std::size_t begin, std::size_t end) { ranges_[i + 1] = counted(begin, end); });
    for (std::size_t i = 1; i < ranges_.size(); ++i) {
      ranges_[i].stops += ranges_[i - 1].stops;
      ranges_[i].loops += ranges_[i - 1].loops;
    }
    Stops stops;
    resize_uninitialized(stops.along, ranges_.back().stops);
    resize_uninitialized(stops.loops, ranges_.back().loops);
    for_numbered_ranges(
        strands_.points.size(), tuning::stop_vertices_a_range,
        [&](std::size_t i, std::size_t begin, std::size_t end) { write(begin, end, ranges_[i], stops); });
    return stops;
  }

 private:
  /// How many come before a range.
  struct Range {
    std::uint32_t stops = 0, loops = 0;
  };

  bool is_node(std::uint32_t v) const { return (strands_.flags[v] & noding::node_flag) != 0; }

  /// Calls visit(strand, first, past) for the vertices of each strand that are in [begin, end).
  template <class Visit>
  void for_each_strand(std::size_t begin, std::size_t end, const Visit& visit) const {
    auto v = static_cast<std::uint32_t>(begin);
    for (std::size_t s = strands_.strand_of(v); v < end; ++s) {
      const auto past = static_cast<std::uint32_t>(std::min<std::size_t>(strands_.ends[s], end));
      visit(s, v, past);
      v = past;
    }
  }

  Range counted(std::size_t begin, std::size_t end) const {
    Range range;
    for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v) range.stops += is_node(v);
    for_each_strand(begin, end, [&](std::size_t s, std::uint32_t first, std::uint32_t) {
      range.loops += first == strands_.begin(s) && !is_node(first);
    });
    return range;
  }

  /// Where nodes are is hard to foresee, so a block of vertices is sorted out first, without branches.
  void write(std::size_t begin, std::size_t end, Range before, Stops& stops) const {
    std::array<std::uint32_t, tuning::stop_vertices_a_block> nodes;
    for_each_strand(begin, end, [&](std::size_t s, std::uint32_t v, std::uint32_t past) {
      if (!is_node(strands_.begin(s))) {
        if (v == strands_.begin(s)) stops.loops[before.loops++] = static_cast<std::uint32_t>(s);
        return;
      }
      while (v < past) {
        std::size_t count = 0;
        for (const std::uint32_t block_end = std::min(v + tuning::stop_vertices_a_block, past); v < block_end; ++v) {
          nodes[count] = v;
          count += is_node(v);
        }
        for (std::size_t i = 0; i < count; ++i)
          stops.along[before.stops++] = {nodes[i], static_cast<std::uint32_t>(s), none, none};
      }
    });
  }

  const Strands& strands_;
  Array<Range> ranges_;
};

/// Puts the stops of a range of whole keys in order, and counts what the range holds.
class RangeOrder {
 public:
  RangeOrder(const LargeArray<Point>& places, Stops& stops, std::size_t begin, std::size_t end)
      : places_(places), stops_(stops), begin_(begin), end_(end) {}

  /// What the range holds.
  NodeCounts run() {
    for (std::size_t first = begin_, last; first < end_; first = last) {
      last = past_key(first);
      if (last - first > 1) sort(first, last);
      for (std::size_t i = first; i < last; ++i) note(i, first);
    }
    return counted_;
  }

 private:
  const Point& place(std::size_t i) const { return places_[stops_.order[i].index]; }

  /// Past the last stop with the key of the first one. Stops at one place have one key.
  std::size_t past_key(std::size_t first) const {
    std::size_t last = first + 1;
    while (last < end_ && stops_.order[last].key == stops_.order[first].key) ++last;
    return last;
  }

  /// By place, and stops of one place along the strands.
  void sort(std::size_t first, std::size_t last) {
    std::sort(stops_.order.data() + first, stops_.order.data() + last, [&](const Keyed& p, const Keyed& q) {
      const Point &p_place = places_[p.index], &q_place = places_[q.index];
      return p_place != q_place ? lexicographically_less(p_place, q_place) : p.index < q.index;
    });
  }

  /// Stop i in the order, of the key that begins at `first`.
  void note(std::size_t i, std::size_t first) {
    stops_.fetch_ahead(i, end_);
    if (i + fetched_ahead < end_) fetch(&places_[stops_.order[i + fetched_ahead].index]);
    const bool begins_node = i == first || place(i) != place(i - 1);
    stops_.begins_node[i] = begins_node;
    counted_.nodes += begins_node;
    counted_.chains += stops_.has_chain_after(stops_.order[i].index);
    counted_.entries += stops_.degree(stops_.order[i].index);
  }

  const LargeArray<Point>& places_;
  Stops& stops_;
  std::size_t begin_, end_;
  NodeCounts counted_;
};

/// Ranges of whole keys, without counts.
Array<NodeRange> ranges_of_keys(const LargeArray<Keyed>& order) {
  Array<NodeRange> ranges;
  ranges.reserve(order.size() / tuning::stops_a_task + 2);
  ranges.push_back({0});
  for (std::size_t i = tuning::stops_a_task; i < order.size(); i += tuning::stops_a_task) {
    while (i < order.size() && order[i].key == order[i - 1].key) ++i;
    ranges.push_back({i});
  }
  ranges.push_back({order.size()});
  return ranges;
}

}  // namespace

Stops find_stops(const Strands& strands) { return StopFinder(strands).run(); }

Array<NodeRange> order_stops(const Strands& strands, Stops& stops) {
  LargeArray<Point> places;
  resize_uninitialized(places, stops.along.size());
  for_ranges(places.size(), tuning::stops_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) places[k] = strands.points[stops.along[k].vertex];
  });
  stops.order = curve_order(places);
  resize_uninitialized(stops.begins_node, stops.order.size());
  Array<NodeRange> ranges = ranges_of_keys(stops.order);
  // What a range holds is counted at the next one, and summed up after that.
  for_ranges(ranges.size() - 1, 1, [&](std::size_t range, std::size_t past) {
    for (; range < past; ++range) {
      NodeRange& next = ranges[range + 1];
      next.before = RangeOrder(places, stops, ranges[range].begin, next.begin).run();
    }
  });
  for (std::size_t range = 1; range < ranges.size(); ++range) ranges[range].before += ranges[range - 1].before;
  return ranges;
}

}  // namespace oblast::internal
