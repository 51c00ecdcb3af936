#include "noding/repeated_pieces.h"

#include <algorithm>

#include "base/call.h"
#include "base/index.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "noding/edge_hashes.h"
#include "noding/edge_table.h"
#include "plane/point_hash.h"

namespace oblast::internal::noding {
namespace {

struct Moved {
  std::uint32_t edge;
  std::uint32_t hash;  ///< the same for both directions
};

LargeArray<Moved> moved_edges(const Strands& strands) {
  const std::size_t count = strands.flags.size();
  constexpr std::size_t edges_a_range = tuning::hashed_edges_a_task;
  const auto is_moved = [&](std::size_t e) { return (strands.flags[e] & moved_flag) != 0; };
  Array<std::size_t> places(range_count(count, edges_a_range) + 1);
  for_numbered_ranges(count, edges_a_range, [&](std::size_t range, std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) places[range + 1] += is_moved(e);
  });
  for (std::size_t range = 1; range < places.size(); ++range) places[range] += places[range - 1];
  LargeArray<Moved> moved;
  resize_uninitialized(moved, places.back());
  for_numbered_ranges(count, edges_a_range, [&](std::size_t range, std::size_t begin, std::size_t end) {
    Moved* to = moved.data() + places[range];
    for (std::size_t e = begin; e < end; ++e) {
      if (!is_moved(e)) continue;
      *to++ = {static_cast<std::uint32_t>(e), edge_hash(hash(strands.points[e]), hash(strands.points[e + 1]))};
    }
  });
  return moved;
}

}  // namespace

LargeArray<RepeatedPiece> flag_repeated_pieces(Strands& strands) {
  LargeArray<RepeatedPiece> repeated;
  const LargeArray<Moved> moved = moved_edges(strands);
  if (moved.size() < 2) return repeated;
  EdgeTable table(strands.points, moved.size());
  Steps steps(moved.size());
  for (std::size_t i = 0; i < moved.size(); ++i) {
    steps();
    if (i + edges_ahead < moved.size()) table.prefetch(moved[i + edges_ahead].hash);
    const std::uint32_t edge = moved[i].edge, first = table.find_or_insert(edge, moved[i].hash);
    if (first == edge) continue;
    repeated.push_back({edge, first});
    for (const std::uint32_t e : {edge, first}) {
      strands.flags[e] |= node_flag;
      strands.flags[e + 1] |= node_flag;
    }
    strands.flags[edge] |= repeated_flag;
  }
  return repeated;
}

void copy_cuts(const Strands& strands, std::span<const RepeatedPiece> repeated, LargeArray<EdgeCut>& cuts) {
  const auto before = [](const EdgeCut& p, const EdgeCut& q) { return p.edge < q.edge; };
  LargeArray<EdgeCut> copies;
  for (const auto [edge, first] : repeated) {
    const auto [begin, end] = std::equal_range(cuts.begin(), cuts.end(), EdgeCut{first, 0, {}}, before);
    const auto old_size = static_cast<std::ptrdiff_t>(copies.size());
    for (auto cut = begin; cut != end; ++cut) copies.push_back({edge, cut->sine, cut->at});
    if (strands.points[edge] != strands.points[first]) std::reverse(copies.begin() + old_size, copies.end());
  }
  if (copies.empty()) return;
  check_count(cuts.size() + copies.size(), "cuts");
  LargeArray<EdgeCut> both;
  resize_uninitialized(both, cuts.size() + copies.size());
  std::merge(cuts.begin(), cuts.end(), copies.begin(), copies.end(), both.begin(), before);
  cuts = std::move(both);
}

}  // namespace oblast::internal::noding
