// From the last vertex to the first, each moves to its place behind the cuts before it:
//
//   before   p0  p1  p2  p3  .   .        cuts x, y of edge 1
//   after    p0  p1  x   y   p2  p3
#include "noding/insert_cuts.h"

#include <algorithm>
#include <numeric>

#include "memory/large_pages.h"

namespace oblast::noding {
namespace {

class CutInsertion {
 public:
  CutInsertion(Strands& strands, std::span<const EdgeCut> cuts)
      : strands_(strands),
        cuts_(cuts),
        from_(static_cast<std::uint32_t>(strands.points.size())),
        to_(from_ + static_cast<std::uint32_t>(cuts.size())) {}

  void run() {
    const bool first_round = strands_.origin.empty();
    resize_in_large_pages(strands_.points, to_);
    resize_in_large_pages(strands_.flags, to_);
    resize_in_large_pages(strands_.origin, to_);
    if (first_round) std::iota(strands_.origin.begin(), strands_.origin.begin() + from_, 0U);
    move_ends();
    for (std::size_t past = cuts_.size(); past > 0;) {
      const std::uint32_t edge = cuts_[past - 1].edge;
      std::size_t first = past;
      while (first > 0 && cuts_[first - 1].edge == edge) --first;
      const bool moved = (strands_.flags[edge] & near_flag) != 0;
      move_vertices(edge + 1);
      put(cuts_.subspan(first, past - first), strands_.origin[edge], moved);
      move_vertices(edge);
      if (moved) strands_.flags[to_] |= moved_flag;
      past = first;
    }
    move_vertices(0);
  }

 private:
  void move_ends() {
    std::uint32_t before = 0;
    for (std::uint32_t& end : strands_.ends) {
      while (before < cuts_.size() && cuts_[before].edge < end) ++before;
      end += before;
    }
  }

  /// Vertices [begin, from_) to where they end at to_. What the last round said of them is over.
  void move_vertices(std::uint32_t begin) {
    constexpr std::uint32_t few = 16;
    if (from_ - begin <= few) {
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

  void put(std::span<const EdgeCut> cuts, std::uint32_t origin, bool moved) {
    to_ -= static_cast<std::uint32_t>(cuts.size());
    const auto flags = static_cast<std::uint8_t>(node_flag | added_flag | (moved ? moved_flag : 0));
    for (std::size_t i = 0; i < cuts.size(); ++i) strands_.points[to_ + i] = cuts[i].at;
    std::fill_n(strands_.flags.begin() + to_, cuts.size(), flags);
    std::fill_n(strands_.origin.begin() + to_, cuts.size(), origin);
  }

  static constexpr auto kept_flags = static_cast<std::uint8_t>(~(moved_flag | near_flag));

  Strands& strands_;
  std::span<const EdgeCut> cuts_;
  std::uint32_t from_, to_;  ///< past the vertices not moved yet, where they are and where they go
};

}  // namespace

void insert_cuts(Strands& strands, std::span<const EdgeCut> cuts) { CutInsertion(strands, cuts).run(); }

}  // namespace oblast::noding
