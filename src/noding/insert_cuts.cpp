// Each vertex moves to its place behind the cuts before it:
//
//   before   p0  p1  p2  p3  .   .        cuts x, y of edge 1
//   after    p0  p1  x   y   p2  p3
//
// Where the points have room for the cuts, from the last vertex to the first. Else to new arrays, on all cores.
#include "noding/insert_cuts.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/index.h"
#include "base/large_pages.h"
#include "base/parallel.h"
#include "base/tuning.h"

namespace oblast::internal::noding {
namespace {

constexpr auto kept_flags = static_cast<std::uint8_t>(~(moved_flag | near_flag | repeated_flag));

/// Flags of the cuts of an edge that has these.
std::uint8_t cut_flags(std::uint8_t of_edge) {
  return static_cast<std::uint8_t>(node_flag | added_flag | ((of_edge & near_flag) != 0 ? moved_flag : 0));
}
/// Flags of the vertex where the first piece of a cut edge starts, from those of the edge.
std::uint8_t first_piece_flags(std::uint8_t of_edge) {
  return static_cast<std::uint8_t>((of_edge & kept_flags) | ((of_edge & near_flag) != 0 ? moved_flag : 0));
}

class CutInsertion {
 public:
  CutInsertion(Strands& strands, std::span<const EdgeCut> cuts)
      : strands_(strands),
        cuts_(cuts),
        from_(static_cast<std::uint32_t>(strands.points.size())),
        to_(from_ + static_cast<std::uint32_t>(cuts.size())) {}

  void run() {
    strands_.points.resize(to_);
    resize_with_zeros(strands_.flags, to_);
    resize_with_zeros(strands_.origin, to_);
    Steps steps(cuts_.size());
    for (std::size_t past = cuts_.size(); past > 0;) {
      steps();
      const std::uint32_t edge = cuts_[past - 1].edge;
      std::size_t first = past;
      while (first > 0 && cuts_[first - 1].edge == edge) --first;
      const std::uint8_t flags = strands_.flags[edge];
      move_vertices(edge + 1);
      put(cuts_.subspan(first, past - first), strands_.origin[edge], cut_flags(flags));
      move_vertices(edge);
      strands_.flags[to_] = first_piece_flags(flags);
      past = first;
    }
    move_vertices(0);
  }

 private:
  /// Vertices [begin, from_) to where they end at to_. What the last round said of them is over.
  void move_vertices(std::uint32_t begin) {
    if (from_ - begin <= tuning::few_moved_vertices) {
      while (from_ > begin) move_vertex(--from_, --to_);
      return;
    }
    const auto move = [&](auto& items) {
      if (from_ != to_) std::move_backward(items.begin() + begin, items.begin() + from_, items.begin() + to_);
    };
    move(strands_.points);
    move(strands_.flags);
    move(strands_.origin);
    to_ -= from_ - begin;
    for (std::uint8_t& flags : std::span(strands_.flags).subspan(to_, from_ - begin)) flags &= kept_flags;
    from_ = begin;
  }
  void move_vertex(std::uint32_t from, std::uint32_t to) {
    strands_.points[to] = strands_.points[from];
    strands_.flags[to] = strands_.flags[from] & kept_flags;
    strands_.origin[to] = strands_.origin[from];
  }

  void put(std::span<const EdgeCut> cuts, std::uint32_t origin, std::uint8_t flags) {
    to_ -= static_cast<std::uint32_t>(cuts.size());
    for (std::size_t i = 0; i < cuts.size(); ++i) strands_.points[to_ + i] = cuts[i].at;
    std::fill_n(strands_.flags.begin() + to_, cuts.size(), flags);
    std::fill_n(strands_.origin.begin() + to_, cuts.size(), origin);
  }

  Strands& strands_;
  std::span<const EdgeCut> cuts_;
  std::uint32_t from_, to_;  ///< past the vertices not moved yet, where they are and where they go
};

/// Vertices and cuts, from one range of vertices after another side by side, to new arrays.
class CutCopy {
 public:
  CutCopy(const Strands& strands, std::span<const EdgeCut> cuts) : strands_(strands), cuts_(cuts) {
    const std::size_t count = strands.points.size() + cuts.size();
    resize_uninitialized(points, count);
    resize_with_zeros(flags, count);
    resize_with_zeros(origin, count);
  }

  void run() {
    // Cuts may be many to a vertex.
    for_ranges(strands_.points.size(), grain(strands_.points.size(), cuts_.size()),
               [&](std::size_t begin, std::size_t end) {
                 copy(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end));
               });
  }

  LargeArray<Point> points;
  Array<std::uint8_t> flags;
  Array<std::uint32_t> origin;

 private:
  void copy(std::uint32_t vertex, std::uint32_t end) {
    auto cut = std::lower_bound(cuts_.begin(), cuts_.end(), vertex,
                                [](const EdgeCut& c, std::uint32_t edge) { return c.edge < edge; });
    auto to = vertex + static_cast<std::uint32_t>(cut - cuts_.begin());
    for (; cut != cuts_.end() && cut->edge < end; vertex = cut[-1].edge + 1) {
      const std::uint32_t edge = cut->edge;
      const std::uint8_t edge_flags = strands_.flags[edge];
      copy_vertices(vertex, edge + 1, to);
      to += edge + 1 - vertex;
      flags[to - 1] = first_piece_flags(edge_flags);
      for (; cut != cuts_.end() && cut->edge == edge; ++cut, ++to) {
        points[to] = cut->at;
        flags[to] = cut_flags(edge_flags);
        origin[to] = strands_.origin[edge];
      }
    }
    copy_vertices(vertex, end, to);
  }

  /// What the last round said of them is over.
  void copy_vertices(std::uint32_t begin, std::uint32_t end, std::uint32_t to) {
    if (end - begin <= tuning::few_moved_vertices) {
      for (; begin < end; ++begin, ++to) {
        points[to] = strands_.points[begin];
        flags[to] = strands_.flags[begin] & kept_flags;
        origin[to] = strands_.origin[begin];
      }
      return;
    }
    std::copy(strands_.points.begin() + begin, strands_.points.begin() + end, points.begin() + to);
    std::transform(strands_.flags.begin() + begin, strands_.flags.begin() + end, flags.begin() + to,
                   [](std::uint8_t f) { return static_cast<std::uint8_t>(f & kept_flags); });
    std::copy(strands_.origin.begin() + begin, strands_.origin.begin() + end, origin.begin() + to);
  }

  const Strands& strands_;
  std::span<const EdgeCut> cuts_;
};

void move_ends(std::span<const EdgeCut> cuts, Strands& strands) {
  std::uint32_t before = 0;
  for (std::uint32_t& end : strands.ends) {
    while (before < cuts.size() && cuts[before].edge < end) ++before;
    end += before;
  }
}

}  // namespace

void insert_cuts(Strands& strands, std::span<const EdgeCut> cuts) {
  check_count(strands.points.size() + cuts.size(), "vertices with those of the cuts");
  if (strands.origin.empty()) {
    resize_with_zeros(strands.origin, strands.points.size());
    std::iota(strands.origin.begin(), strands.origin.end(), 0U);
  }
  move_ends(cuts, strands);
  if (strands.points.capacity() >= strands.points.size() + cuts.size()) {
    CutInsertion(strands, cuts).run();
    return;
  }
  CutCopy cut(strands, cuts);
  cut.run();
  strands.points = std::move(cut.points);
  strands.flags = std::move(cut.flags);
  strands.origin = std::move(cut.origin);
}

}  // namespace oblast::internal::noding
